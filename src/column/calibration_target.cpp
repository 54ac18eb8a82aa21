#include "column/calibration_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::inline column {

namespace {

constexpr double log_law_values = 2.0;  ///< u_* and k_s: what the points of the log law are worth together
constexpr std::array uses = {"depth-mean", "profile", "friction-velocity", "section"};

/// Friction velocity as a profile shows it. The one of the stress, sqrt(g S0 (H - d_h)), is fixed by the
/// depth and cannot tell parameters apart.
double profile_friction_velocity(const ColumnResult& column) {
    return column.log_law.valid ? column.log_law.friction_velocity : column.friction_velocity;
}

bool is_used(const CalibrationOptions& options, const char* what) {
    return options.use.empty() ||
           std::find(options.use.begin(), options.use.end(), what) != options.use.end();
}

void check_uses(const CalibrationOptions& options) {
    for (const std::string& use : options.use) {
        if (std::find(uses.begin(), uses.end(), use) != uses.end()) continue;
        throw InputError(
            fmt::format("unknown measured quantity \"{}\" to fit to: choose among depth-mean, profile, "
                        "friction-velocity, section",
                        use));
    }
}

/// Depth mean above the datum of the rough log law, 0 where it would be negative.
double log_law_mean(const Measured& m, double depth) {
    constexpr int points = 400;
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
        sum += std::max(
            0.0, rough_log_law(depth * (i + 0.5) / points, *m.friction_velocity, *m.equivalent_roughness));
    }
    return sum / points;
}

/// Value of a section's field at a point, bilinear between the centres.
double value_at(const SectionResult& section, const std::vector<double>& values, double y, double z) {
    SectionResult field;
    field.y = section.y;
    field.z = section.z;
    field.velocity = values;
    return field.velocity_at(y, z);
}

}  // namespace

CalibrationTarget::CalibrationTarget(const Case& c, const CalibrationOptions& options,
                                     const std::filesystem::path& section)
    : case_(c) {
    check_uses(options);
    const Measured& m = c.measured;
    depth_mean_ = m.depth_mean_velocity;
    depth_mean_uncertainty_ = options.depth_mean_uncertainty * std::abs(depth_mean_.value_or(0.0));
    friction_velocity_ = m.friction_velocity;
    friction_velocity_uncertainty_ =
        options.friction_velocity_uncertainty * std::abs(friction_velocity_.value_or(0.0));
    profile_uncertainty_ = options.profile_uncertainty;
    stress_uncertainty_ = options.stress_uncertainty * c.streamwise_gravity() * c.channel.depth;
    if (!m.velocity_profile.empty()) {
        profile_ = read_velocity_measurements(c);
        profile_name_ = "measured profile";
    } else if (m.friction_velocity && m.equivalent_roughness) {
        profile_ = measured_log_law(c);
        profile_name_ = "log-law profile";
        profile_weight_ = std::sqrt(log_law_values / static_cast<double>(profile_.height.size()));
    }
    for (double& z : profile_.height) z -= c.datum();
    if (profile_.uncertainty.empty()) {
        for (const double u : profile_.velocity) {
            profile_.uncertainty.push_back(options.profile_uncertainty * std::abs(u));
        }
    }
    if (!section.empty()) {
        if (!has_section(c)) {
            throw InputError(
                section.string() +
                ": points of a cross-section are compared with the section twin, which the case does "
                "not have: it needs three dimensions and side walls");
        }
        section_ = section_points_of(read_section_record(section), c);
    }
    uses_depth_mean_ = depth_mean_ && is_used(options, "depth-mean");
    uses_profile_ = !profile_.height.empty() && is_used(options, "profile");
    uses_section_ = !section_.empty() && is_used(options, "section");
    // Where there is a profile the friction velocity says nothing of its own, unless it is asked for.
    const bool asked = !options.use.empty() && is_used(options, "friction-velocity");
    uses_friction_velocity_ =
        friction_velocity_ && (asked || (options.use.empty() && profile_.height.empty()));
    if (!uses_depth_mean_ && !uses_friction_velocity_ && !uses_profile_ && !uses_section_) {
        throw InputError(fmt::format(
            "nothing to calibrate with{}: give [measured] depth_mean_velocity, friction_velocity with "
            "equivalent_roughness, or velocity_profile in the case{}",
            c.title.empty() ? "" : " in \"" + c.title + "\"",
            options.use.empty() ? "" : ", or name others after --use"));
    }
    const auto positive = [](double v) { return v > 0.0; };
    if ((uses_depth_mean_ && !positive(depth_mean_uncertainty_)) ||
        (uses_friction_velocity_ && !positive(friction_velocity_uncertainty_)) ||
        (uses_profile_ && !std::all_of(profile_.uncertainty.begin(), profile_.uncertainty.end(), positive))) {
        throw InputError(
            "each measured value needs an uncertainty greater than 0: give relative uncertainties greater "
            "than 0, and u_uncertainty for measured velocities of 0");
    }
}

std::vector<CalibrationTarget::SectionValue> CalibrationTarget::section_values(
    const Case& c, const SectionResult& section) const {
    std::vector<SectionValue> values;
    const std::vector<double> means = section.depth_means(c.datum(), c.total_depth());
    const auto mean_at = [&](double y) { return place_in(section.y, y).in(means); };
    // The points keep their heights over the datum when the bed's elements change theirs.
    const double shift = c.datum() - case_.datum();
    for (std::size_t i = 0; i < section_.y.size(); ++i) {
        const bool mean = std::isnan(section_.z[i]);
        if (!section_.velocity.empty() && std::isfinite(section_.velocity[i])) {
            const double u = section_.velocity[i];
            const bool own = !section_.uncertainty.empty() && std::isfinite(section_.uncertainty[i]);
            values.push_back(
                {mean ? mean_at(section_.y[i]) : section.velocity_at(section_.y[i], section_.z[i] + shift), u,
                 own ? section_.uncertainty[i] : profile_uncertainty_ * std::abs(u), false});
        }
        // Among the bed's elements the drag carries part of the stress.
        const bool above = !mean && section_.z[i] + shift > c.crest();
        if (above && !section_.reynolds_stress.empty() && std::isfinite(section_.reynolds_stress[i])) {
            const double stress =
                value_at(section, section.shear_stress, section_.y[i], section_.z[i] + shift);
            values.push_back(
                {stress / c.fluid.density, section_.reynolds_stress[i], stress_uncertainty_, true});
        }
    }
    return values;
}

double CalibrationTarget::independent_values() const {
    const double points = static_cast<double>(profile_.height.size()) * profile_weight_ * profile_weight_;
    double section = 0.0;
    for (std::size_t i = 0; i < section_.y.size() && uses_section_; ++i) {
        section += !section_.velocity.empty() && std::isfinite(section_.velocity[i]) ? 1.0 : 0.0;
        const bool stress = !section_.reynolds_stress.empty() && std::isfinite(section_.reynolds_stress[i]);
        section += stress && section_.z[i] > case_.crest() ? 1.0 : 0.0;
    }
    return (uses_depth_mean_ ? 1.0 : 0.0) + (uses_friction_velocity_ ? 1.0 : 0.0) +
           (uses_profile_ ? points : 0.0) + section;
}

std::vector<double> CalibrationTarget::residuals(const Case& c, const Centreline& computed) const {
    const ColumnResult& column = computed.column;
    std::vector<double> result;
    if (uses_depth_mean_) {
        result.push_back((column.depth_mean_velocity - *depth_mean_) / depth_mean_uncertainty_);
    }
    if (uses_friction_velocity_) {
        result.push_back((profile_friction_velocity(column) - *friction_velocity_) /
                         friction_velocity_uncertainty_);
    }
    for (std::size_t i = 0; i < profile_.height.size() && uses_profile_; ++i) {
        const double u = column.velocity_at(c.datum() + profile_.height[i]);
        result.push_back(profile_weight_ * (u - profile_.velocity[i]) / profile_.uncertainty[i]);
    }
    if (uses_section_ && computed.section) {
        for (const SectionValue& value : section_values(c, *computed.section)) {
            result.push_back((value.computed - value.measured) / value.uncertainty);
        }
    }
    return result;
}

void CalibrationTarget::add_points(const char* name, bool stress, const Case& before_case,
                                   const Centreline& before, const Case& after_case, const Centreline& after,
                                   std::vector<FittedQuantity>& result) const {
    if (!before.section || !after.section) return;
    const std::vector<SectionValue> was = section_values(before_case, *before.section);
    const std::vector<SectionValue> is = section_values(after_case, *after.section);
    FittedQuantity q{name, stress ? "m2/s2" : "m/s", 0};
    q.fitted_to = uses_section_;
    for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i) {
        if (was[i].stress != stress) continue;
        ++q.points;
        q.measured += was[i].measured;
        q.uncertainty += was[i].uncertainty;
        q.before += was[i].computed;
        q.after += is[i].computed;
        q.relative_misfit_before += std::pow(was[i].computed - was[i].measured, 2);
        q.relative_misfit_after += std::pow(is[i].computed - is[i].measured, 2);
    }
    if (q.points == 0) return;
    const auto n = static_cast<double>(q.points);
    for (double* const sum : {&q.measured, &q.uncertainty, &q.before, &q.after}) *sum /= n;
    q.relative_misfit_before = std::sqrt(q.relative_misfit_before / n) / std::abs(q.measured);
    q.relative_misfit_after = std::sqrt(q.relative_misfit_after / n) / std::abs(q.measured);
    result.push_back(q);
}

std::vector<FittedQuantity> CalibrationTarget::compare(const Case& before_case, const Centreline& before,
                                                       const Case& after_case,
                                                       const Centreline& after) const {
    std::vector<FittedQuantity> result;
    const auto add = [&result](const char* name, const char* unit, bool used, double measured,
                               double uncertainty, double was, double is) {
        FittedQuantity q{
            name, unit, 1, measured, uncertainty, was, is, was / measured - 1.0, is / measured - 1.0};
        q.fitted_to = used;
        result.push_back(q);
    };
    if (depth_mean_) {
        add("depth-mean velocity", "m/s", uses_depth_mean_, *depth_mean_, depth_mean_uncertainty_,
            before.column.depth_mean_velocity, after.column.depth_mean_velocity);
    }
    if (friction_velocity_) {
        add("friction velocity", "m/s", uses_friction_velocity_, *friction_velocity_,
            friction_velocity_uncertainty_, profile_friction_velocity(before.column),
            profile_friction_velocity(after.column));
    }
    const Measured& m = case_.measured;
    if (m.equivalent_roughness && m.friction_velocity && before.column.log_law.valid &&
        after.column.log_law.valid) {
        // ln k_s = ln z - kappa (u/u_* - 8.5): the errors of u and u_*, which are independent, count kappa
        // u/u_*.
        const double steps = log_law_kappa * log_law_mean(m, case_.channel.depth) / *m.friction_velocity;
        const double relative =
            steps * std::hypot(profile_uncertainty_, friction_velocity_uncertainty_ / *m.friction_velocity);
        add("equivalent roughness", "m", false, *m.equivalent_roughness, relative * *m.equivalent_roughness,
            before.column.log_law.equivalent_roughness, after.column.log_law.equivalent_roughness);
    }
    if (!profile_.height.empty()) {
        const auto n = static_cast<double>(profile_.height.size());
        FittedQuantity q{profile_name_, "m/s", profile_.height.size()};
        q.fitted_to = uses_profile_;
        for (std::size_t i = 0; i < profile_.height.size(); ++i) {
            const double was = before.column.velocity_at(before_case.datum() + profile_.height[i]);
            const double is = after.column.velocity_at(after_case.datum() + profile_.height[i]);
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
    if (!section_.empty()) {
        add_points("section velocities", false, before_case, before, after_case, after, result);
        add_points("section stresses", true, before_case, before, after_case, after, result);
    }
    return result;
}

std::string CalibrationTarget::contradiction() const {
    const Measured& m = case_.measured;
    if (!uses_depth_mean_ || !uses_profile_ || !m.velocity_profile.empty()) return {};
    const double mean = log_law_mean(m, case_.channel.depth);
    const double difference = mean / *depth_mean_ - 1.0;
    constexpr double deviations = 2.0;
    if (std::abs(mean - *depth_mean_) < deviations * depth_mean_uncertainty_) return {};
    return fmt::format(
        "the measured values contradict each other: the log law through u* = {:.4g} m/s and ks = {:.4g} m "
        "has the depth mean {:.4g} m/s, {:+.1f} % from the measured {:.4g} m/s, and the fit must miss one "
        "of them; choose what to trust with --use depth-mean or --use profile",
        *m.friction_velocity, *m.equivalent_roughness, mean, 100.0 * difference, *depth_mean_);
}

}  // namespace riffle::inline column
