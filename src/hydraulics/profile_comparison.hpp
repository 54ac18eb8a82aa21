#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace riffle::inline hydraulics {

/// Mean squared error percentage of the thesis at one point: [(measured - computed)/measured]^2 x 100, the
/// 100 outside of the square: 0.5 is a relative error of 7 %, 2.5 of 16 %. Infinite for a measured 0.
[[nodiscard]] double squared_error_percentage(double measured, double computed);

/// One measured point beside the computed profile.
struct ComparedPoint {
    double z = 0;
    double measured = 0;
    double computed = 0;        ///< interpolated linearly at z
    double relative_error = 0;  ///< (computed - measured)/measured; not a number for a measured 0
    double msep = 0;            ///< squared_error_percentage
};

/// What is left out of a comparison, and why.
enum class LeftOut { above_computed, below_computed, unmeasured };
struct LeftOutPoint {
    double z = 0;
    double measured = 0;
    LeftOut reason = LeftOut::unmeasured;
};

/// Errors over a number of points.
struct ErrorMeasures {
    std::size_t points = 0;
    std::size_t measured_zero = 0;  ///< of them: points without relative error
    double mean_relative = 0;       ///< bias
    double rms_relative = 0;        ///< root mean square of the relative errors
    double maximum_relative = 0;    ///< largest magnitude
    double height_of_maximum = 0;   ///< where, m
    double mean_msep = 0;           ///< the thesis' MSEP of a profile: 100 rms_relative^2
    double maximum_msep = 0;
    double rms_difference = 0;  ///< of computed - measured, in their unit
};

/// A computed profile at the heights of a measured one.
struct ProfileComparison {
    std::vector<ComparedPoint> points;   ///< in the order of the measured ones
    std::vector<LeftOutPoint> left_out;  ///< measured points outside of the computed range, or not numbers
    ErrorMeasures errors;                ///< over all `points`
};

/// A profile: values over heights, m.
struct ProfileSpan {
    std::span<const double> z;
    std::span<const double> value;
};

/// Compare a computed profile, interpolated linearly, with a measured one at the measured heights. Throws
/// InputError if heights and values differ in number or the computed heights do not rise or are not numbers.
/// Nothing is extrapolated: measured points outside of the computed heights come back in `left_out`.
[[nodiscard]] ProfileComparison compare_profiles(const ProfileSpan& computed, const ProfileSpan& measured);

/// The same for the gradients: the difference quotient between each two neighbouring measured points, beside
/// that of the computed profile between the same heights, so that both carry the same truncation error; z is
/// the middle. The measured heights must rise, too.
[[nodiscard]] ProfileComparison compare_gradients(const ProfileSpan& computed, const ProfileSpan& measured);

/// Errors over the points with from <= z <= to; all not a number where there are none.
[[nodiscard]] ErrorMeasures errors_between(std::span<const ComparedPoint> points, double from, double to);

}  // namespace riffle::inline hydraulics
