#include "hydraulics/profile_comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "base/not_a_number.hpp"

namespace riffle::inline hydraulics {

namespace {

void require_same_number(const ProfileSpan& profile, std::string_view name) {
    if (profile.z.size() != profile.value.size()) {
        throw InputError(fmt::format("profile comparison: {} heights and {} values of the {} profile",
                                     profile.z.size(), profile.value.size(), name));
    }
}

void require_rising(const ProfileSpan& profile, std::string_view name) {
    for (std::size_t i = 0; i < profile.z.size(); ++i) {
        const bool rises = i == 0 || profile.z[i] > profile.z[i - 1];
        if (rises && std::isfinite(profile.z[i]) && std::isfinite(profile.value[i])) continue;
        throw InputError(
            fmt::format("profile comparison: the {} profile needs numbers at rising heights; point {} is z = "
                        "{}, value {}",
                        name, i + 1, profile.z[i], profile.value[i]));
    }
}

ComparedPoint compared(double z, double measured, double computed) {
    const double relative = measured == 0.0 ? not_a_number : (computed - measured) / measured;
    return {z, measured, computed, relative, squared_error_percentage(measured, computed)};
}

/// On which side the height is outside of the computed range; none if it is inside.
std::optional<LeftOut> outside(const ProfileSpan& computed, double z) {
    if (computed.z.empty() || z > computed.z.back()) return LeftOut::above_computed;
    if (z < computed.z.front()) return LeftOut::below_computed;
    return std::nullopt;
}

ProfileComparison with_errors(ProfileComparison comparison) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    comparison.errors = errors_between(comparison.points, -infinite, infinite);
    return comparison;
}

}  // namespace

double squared_error_percentage(double measured, double computed) {
    if (measured == 0.0) return std::numeric_limits<double>::infinity();
    const double relative = (measured - computed) / measured;
    return 100.0 * relative * relative;
}

ProfileComparison compare_profiles(const ProfileSpan& computed, const ProfileSpan& measured) {
    require_same_number(computed, "computed");
    require_same_number(measured, "measured");
    require_rising(computed, "computed");
    ProfileComparison result;
    for (std::size_t i = 0; i < measured.z.size(); ++i) {
        const double z = measured.z[i];
        const double value = measured.value[i];
        if (!std::isfinite(z) || !std::isfinite(value)) {
            result.left_out.push_back({z, value, LeftOut::unmeasured});
        } else if (const auto reason = outside(computed, z)) {
            result.left_out.push_back({z, value, *reason});
        } else {
            result.points.push_back(compared(z, value, place_in(computed.z, z).in(computed.value)));
        }
    }
    return with_errors(std::move(result));
}

ProfileComparison compare_gradients(const ProfileSpan& computed, const ProfileSpan& measured) {
    require_same_number(computed, "computed");
    require_same_number(measured, "measured");
    require_rising(computed, "computed");
    require_rising(measured, "measured");
    ProfileComparison result;
    for (std::size_t i = 1; i < measured.z.size(); ++i) {
        const double lower = measured.z[i - 1];
        const double upper = measured.z[i];
        const double z = 0.5 * (lower + upper);
        const double gradient = (measured.value[i] - measured.value[i - 1]) / (upper - lower);
        auto reason = outside(computed, lower);
        if (!reason) reason = outside(computed, upper);
        if (reason) {
            result.left_out.push_back({z, gradient, *reason});
            continue;
        }
        const double difference =
            place_in(computed.z, upper).in(computed.value) - place_in(computed.z, lower).in(computed.value);
        result.points.push_back(compared(z, gradient, difference / (upper - lower)));
    }
    return with_errors(std::move(result));
}

ErrorMeasures errors_between(std::span<const ComparedPoint> points, double from, double to) {
    ErrorMeasures errors;
    double sum = 0;
    double squares = 0;
    double differences = 0;
    for (const ComparedPoint& point : points) {
        if (!(point.z >= from && point.z <= to)) continue;
        ++errors.points;
        differences += (point.computed - point.measured) * (point.computed - point.measured);
        if (std::isnan(point.relative_error)) {
            ++errors.measured_zero;
            continue;
        }
        sum += point.relative_error;
        squares += point.relative_error * point.relative_error;
        if (std::abs(point.relative_error) >= errors.maximum_relative) {
            errors.maximum_relative = std::abs(point.relative_error);
            errors.height_of_maximum = point.z;
        }
    }
    const auto relative = static_cast<double>(errors.points - errors.measured_zero);
    errors.rms_difference = std::sqrt(differences / static_cast<double>(errors.points));
    if (errors.points == errors.measured_zero) {
        errors.maximum_relative = not_a_number;
        errors.height_of_maximum = not_a_number;
    }
    errors.mean_relative = sum / relative;
    errors.rms_relative = std::sqrt(squares / relative);
    errors.mean_msep = 100.0 * squares / relative;
    errors.maximum_msep = 100.0 * errors.maximum_relative * errors.maximum_relative;
    return errors;
}

}  // namespace riffle::inline hydraulics
