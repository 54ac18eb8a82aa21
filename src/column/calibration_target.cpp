#include "column/calibration_target.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/error.hpp"

namespace riffle {

namespace {

constexpr double log_law_values = 2.0;  ///< u_* and k_s: what the points of the log law are worth together

/// Friction velocity as a profile shows it. The one of the stress, sqrt(g S0 (H - d_h)), is fixed by the
/// depth and cannot tell parameters apart.
double profile_friction_velocity(const ColumnResult& column) {
    return column.log_law.valid ? column.log_law.friction_velocity : column.friction_velocity;
}

}  // namespace

CalibrationTarget::CalibrationTarget(const Case& c, const CalibrationOptions& options) {
    const Measured& m = c.measured;
    depth_mean_ = m.depth_mean_velocity;
    depth_mean_uncertainty_ = options.depth_mean_uncertainty * std::abs(depth_mean_.value_or(0.0));
    if (!m.velocity_profile.empty()) {
        profile_ = read_velocity_measurements(c);
        profile_name_ = "measured profile";
    } else if (m.friction_velocity && m.equivalent_roughness) {
        profile_ = measured_log_law(c);
        profile_name_ = "log-law profile";
        profile_weight_ = std::sqrt(log_law_values / static_cast<double>(profile_.height.size()));
    } else if (m.friction_velocity) {
        friction_velocity_ = m.friction_velocity;
        friction_velocity_uncertainty_ =
            options.friction_velocity_uncertainty * std::abs(*friction_velocity_);
    }
    for (double& z : profile_.height) z -= c.datum();
    if (profile_.uncertainty.empty()) {
        for (const double u : profile_.velocity) {
            profile_.uncertainty.push_back(options.profile_uncertainty * std::abs(u));
        }
    }
    if (!depth_mean_ && !friction_velocity_ && profile_.height.empty()) {
        throw InputError(
            "nothing to calibrate with: give [measured] depth_mean_velocity, friction_velocity with "
            "equivalent_roughness, or velocity_profile in the case");
    }
    const auto positive = [](double v) { return v > 0.0; };
    if ((depth_mean_ && !positive(depth_mean_uncertainty_)) ||
        (friction_velocity_ && !positive(friction_velocity_uncertainty_)) ||
        !std::all_of(profile_.uncertainty.begin(), profile_.uncertainty.end(), positive)) {
        throw InputError(
            "each measured value needs an uncertainty greater than 0: give relative uncertainties greater "
            "than 0, "
            "and u_uncertainty for measured velocities of 0");
    }
}

int CalibrationTarget::size() const {
    return (depth_mean_ ? 1 : 0) + (friction_velocity_ ? 1 : 0) + static_cast<int>(profile_.height.size());
}

double CalibrationTarget::independent_values() const {
    const double points = static_cast<double>(profile_.height.size()) * profile_weight_ * profile_weight_;
    return (depth_mean_ ? 1.0 : 0.0) + (friction_velocity_ ? 1.0 : 0.0) + points;
}

std::vector<double> CalibrationTarget::residuals(const Case& c, const ColumnResult& column) const {
    std::vector<double> result;
    if (depth_mean_) {
        result.push_back((column.depth_mean_velocity - *depth_mean_) / depth_mean_uncertainty_);
    }
    if (friction_velocity_) {
        result.push_back((profile_friction_velocity(column) - *friction_velocity_) /
                         friction_velocity_uncertainty_);
    }
    for (std::size_t i = 0; i < profile_.height.size(); ++i) {
        const double u = column.velocity_at(c.datum() + profile_.height[i]);
        result.push_back(profile_weight_ * (u - profile_.velocity[i]) / profile_.uncertainty[i]);
    }
    return result;
}

std::vector<FittedQuantity> CalibrationTarget::compare(const Case& before_case, const ColumnResult& before,
                                                       const Case& after_case,
                                                       const ColumnResult& after) const {
    std::vector<FittedQuantity> result;
    const auto add = [&result](const char* name, double measured, double uncertainty, double was, double is) {
        result.push_back(
            {name, "m/s", 1, measured, uncertainty, was, is, was / measured - 1.0, is / measured - 1.0});
    };
    if (depth_mean_) {
        add("depth-mean velocity", *depth_mean_, depth_mean_uncertainty_, before.depth_mean_velocity,
            after.depth_mean_velocity);
    }
    if (friction_velocity_) {
        add("friction velocity", *friction_velocity_, friction_velocity_uncertainty_,
            profile_friction_velocity(before), profile_friction_velocity(after));
    }
    if (!profile_.height.empty()) {
        const auto n = static_cast<double>(profile_.height.size());
        FittedQuantity q{profile_name_, "m/s", profile_.height.size()};
        for (std::size_t i = 0; i < profile_.height.size(); ++i) {
            const double was = before.velocity_at(before_case.datum() + profile_.height[i]);
            const double is = after.velocity_at(after_case.datum() + profile_.height[i]);
            q.measured += profile_.velocity[i] / n;
            q.uncertainty += profile_.uncertainty[i] / n;
            q.before += was / n;
            q.after += is / n;
            q.relative_misfit_before += std::pow(was - profile_.velocity[i], 2) / n;
            q.relative_misfit_after += std::pow(is - profile_.velocity[i], 2) / n;
        }
        q.relative_misfit_before = std::sqrt(q.relative_misfit_before) / std::abs(q.measured);
        q.relative_misfit_after = std::sqrt(q.relative_misfit_after) / std::abs(q.measured);
        result.push_back(q);
    }
    return result;
}

}  // namespace riffle
