// Departure of the mean velocity and its gradient from the measured profile and the column twin.

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "base/not_a_number.hpp"
#include "hydraulics/profile_comparison.hpp"

namespace riffle::inline analysis {

namespace {

Curve error_curve(std::string name, Origin origin, const ProfileComparison& comparison,
                  double ComparedPoint::*member, int variant = 0) {
    std::vector<double> x;
    std::vector<double> z;
    for (const ComparedPoint& point : comparison.points) {
        x.push_back(point.*member);
        z.push_back(point.z);
    }
    return make_curve(std::move(name), origin, Mark::line_and_points, x, z, variant);
}

/// What the thesis states of its simulations in as many dimensions.
struct ThesisErrors {
    double upper, lower, gradient;  ///< MSEP, %
    const char* name;
};
ThesisErrors thesis_errors(const Case& c) {
    return c.channel.dimensions == 3 ? ThesisErrors{0.2, 4.5, 20.0, "thesis, 3D simulations"}
                                     : ThesisErrors{0.5, 2.5, 12.0, "thesis, 2D simulations"};
}

/// MSEP above and below 0.25 h_w over the datum, as the thesis states them.
void add_error_findings(const Case& c, const ProfileComparison& velocity, const ProfileComparison& gradient,
                        const std::string& against_what, Analysis& analysis) {
    constexpr double lowest = -std::numeric_limits<double>::infinity();
    const double split = c.datum() + 0.25 * c.channel.depth;
    const ThesisErrors thesis = thesis_errors(c);
    const auto add = [&](const char* key, const char* label, const char* unit, double value,
                         std::optional<double> reference, const char* more = "") {
        if (!std::isfinite(value)) return;
        analysis.findings.push_back(against(make_finding(chapters::profiles, key, label, unit, value),
                                            reference, thesis.name, "against: " + against_what + more));
    };
    add("velocity_error_rms", "rms relative departure of u from the measured profile", "1",
        velocity.errors.rms_relative, std::nullopt);
    add("msep_velocity_upper", "MSEP of u above 0.25 h_w over the datum", "%",
        errors_between(velocity.points, split, c.total_depth()).mean_msep, thesis.upper);
    add("msep_velocity_lower", "MSEP of u below 0.25 h_w over the datum", "%",
        errors_between(velocity.points, lowest, split).mean_msep, thesis.lower);
    add("msep_gradient_lower", "MSEP of du/dz below 0.25 h_w over the datum", "%",
        errors_between(gradient.points, lowest, split).mean_msep, thesis.gradient);
}

}  // namespace

void add_profile_errors(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure error = profile_figure("velocity_error_profile", "Departure of the velocity",
                                  "Relative departure of the time-mean velocity from what each curve names, "
                                  "(u - u_ref)/u_ref.",
                                  "thesis chapter 4", make_axis("relative departure of u", "1"));
    Figure square = profile_figure("msep_profile", "MSEP of velocity and gradient",
                                   "Mean square error percentage of the thesis, 100 ((u_exp - u)/u_exp)^2: "
                                   "0.5 % is a departure of 7 %, 2.5 % of 16 %.",
                                   "thesis chapter 4, MSEP", make_axis("MSEP", "%"));
    const FlowRecord::Measured& measured = record.measured();
    // Between side walls the mean over the width is not the centreline's profile, which was measured.
    const bool of_the_width = record.origin() == Origin::simulated && c.has_side_walls();
    if (measured.profile.height.size() > 1 && !of_the_width) {
        const ProfileSpan points{measured.profile.height, measured.profile.velocity};
        const ProfileComparison velocity = compare_profiles({p.z, p.velocity}, points);
        const ProfileComparison gradient = compare_gradients({p.z, p.velocity}, points);
        if (!velocity.left_out.empty()) {
            analysis.warnings.push_back(
                fmt::format("{} of {} points of the measured profile lie outside of the computed heights, or "
                            "are not numbers, and are left out of its comparison",
                            velocity.left_out.size(), measured.profile.height.size()));
        }
        error.curves.push_back(error_curve("against " + measured_curve_name(measured), Origin::measured,
                                           velocity, &ComparedPoint::relative_error));
        square.curves.push_back(error_curve("velocity", Origin::simulated, velocity, &ComparedPoint::msep));
        square.curves.push_back(
            error_curve("velocity gradient", Origin::simulated, gradient, &ComparedPoint::msep, 1));
        add_error_findings(c, velocity, gradient,
                           measured.from_law ? measured_name(c) + ", its log law" : "measured profile",
                           analysis);
    }
    if (record.column() != nullptr && p.velocity_deviation.size() == p.z.size() &&
        p.column_velocity.size() == p.z.size()) {
        std::vector<double> relative;
        for (std::size_t i = 0; i < p.z.size(); ++i) {
            relative.push_back(p.column_velocity[i] != 0.0 ? p.velocity_deviation[i] / p.column_velocity[i]
                                                           : not_a_number);
        }
        error.curves.push_back(
            profile_curve(of_the_width ? "against the section twin" : "against the column twin",
                          Origin::column, relative, p.z));
    }
    if (record.column() != nullptr && record.origin() == Origin::measured) {
        const ColumnProfile& column = record.column()->profile;
        const ProfileComparison beside = compare_profiles({column.z, column.velocity}, {p.z, p.velocity});
        error.curves.push_back(
            error_curve("column twin", Origin::column, beside, &ComparedPoint::relative_error));
        square.curves.push_back(error_curve("column twin", Origin::column, beside, &ComparedPoint::msep));
        if (std::isfinite(beside.errors.mean_msep)) {
            analysis.findings.push_back(make_finding(chapters::profiles, "msep_column",
                                                     "MSEP of the column twin's u at the measured points",
                                                     "%", beside.errors.mean_msep));
        }
    }
    const std::string why = of_the_width ? "the profile is the mean over the width between side "
                                           "walls, the measured one the centreline's: see "
                                           "centreline_msep_profile of the cross-section"
                            : measured.note.empty()
                                ? "no measured profile is known: the case names none "
                                  "([measured] velocity_profile, or friction_velocity and "
                                  "equivalent_roughness); --measured FILE gives one"
                                : measured.note;
    if (error.curves.empty()) {
        add_missing(record, analysis, std::move(error), why);
    } else {
        analysis.figures.push_back(std::move(error));
    }
    if (square.curves.empty()) {
        add_missing(record, analysis, std::move(square), why);
    } else {
        analysis.figures.push_back(std::move(square));
    }
}

}  // namespace riffle::inline analysis
