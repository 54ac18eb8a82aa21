#pragma once

#include <optional>
#include <span>

#include "hydraulics/profile_fit.hpp"

namespace riffle::inline hydraulics {

/// Fit of the rough log law u/u_* = ln((z - z_0)/k_s)/kappa + 8.5 (thesis 2.3). Half-widths of 95 % by linear
/// propagation, and intervals that hold 95 % also where the points bound a number only poorly
/// (linear_fit.hpp, separable_fit.hpp): k_s depends on the points exponentially, and the zero plane is often
/// hardly bounded.
struct LogLawFit : FitQuality {
    double friction_velocity = 0;             ///< u_*, m/s
    double equivalent_roughness = 0;          ///< k_s, m
    double zero_plane = 0;                    ///< z_0 over the level of z, m
    double friction_velocity_half_width = 0;  ///< of the 95 % interval
    double equivalent_roughness_half_width = 0;
    double zero_plane_half_width = 0;
    Interval friction_velocity_interval;  ///< 95 %
    Interval equivalent_roughness_interval;
    Interval zero_plane_interval;  ///< the plane itself twice where it was given
};

/// Fit u_* and k_s with the zero plane given (linear least squares in ln(z - zero_plane)). Needs 3 points.
[[nodiscard]] LogLawFit fit_log_law(const VelocityPoints& points, double kappa, FitRange range = {});

/// The same without uncertainties.
[[nodiscard]] LogLawFit fit_log_law(std::span<const double> z, std::span<const double> velocity, double kappa,
                                    double zero_plane, double from, double to);

/// Fit u_*, k_s and the zero plane together; `points.zero_plane` does not matter. The plane is looked for
/// from 0.001 to 3 times the range of the points below the lowest of them. Needs 4 points.
[[nodiscard]] LogLawFit fit_log_law_with_zero_plane(const VelocityPoints& points, double kappa,
                                                    FitRange range = {});

/// The same without uncertainties.
[[nodiscard]] LogLawFit fit_log_law_with_zero_plane(std::span<const double> z,
                                                    std::span<const double> velocity, double kappa,
                                                    double from, double to);

/// Depth mean of a profile over 0 < z - zero_plane < depth, m/s: by trapezoids between the points, below the
/// lowest and above the highest by the rough log law fitted to all (below its height of zero velocity the
/// water is at rest). Points outside of the depth are left out. Nothing where the law cannot be fitted.
[[nodiscard]] std::optional<double> profile_depth_mean(const VelocityPoints& points, double depth);

}  // namespace riffle::inline hydraulics
