// Vertical profiles of the time means: velocity and its gradient, stresses, turbulence intensities, pressure.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "hydraulics/profile_comparison.hpp"
#include "hydraulics/turbulence_laws.hpp"

namespace riffle {

namespace {

constexpr const char* chapter = "profiles";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Figure profile_figure(std::string key, std::string title, std::string caption, std::string source, Axis x) {
    return make_figure(chapter, std::move(key), std::move(title), std::move(caption), std::move(source),
                       std::move(x), make_axis("height above the bed level z", "m"));
}

Curve profile_curve(std::string name, Origin origin, const std::vector<double>& values,
                    const std::vector<double>& z, Mark mark = Mark::line) {
    return make_curve(std::move(name), origin, mark, values, z);
}

const char* own_name(const FlowRecord& record) {
    return record.origin() == Origin::simulated ? "simulated" : "measured";
}

/// A curve of the column twin, thinned to what a figure can show.
Curve column_curve(const ColumnProfile& column, const std::vector<double>& values) {
    constexpr std::size_t most = 300;
    return profile_curve("column twin", Origin::column, thinned(values, most), thinned(column.z, most));
}

std::string measured_curve_name(const FlowRecord::Measured& measured) {
    return measured.from_law ? "measured: rough log law (2.3) of its u* and ks" : "measured";
}

void add_measured_points(Figure& figure, const FlowRecord::Measured& measured) {
    if (measured.profile.height.empty()) return;
    Curve curve = profile_curve(measured_curve_name(measured), Origin::measured, measured.profile.velocity,
                                measured.profile.height, measured.from_law ? Mark::line : Mark::points);
    for (const double uncertainty : measured.profile.uncertainty) {
        constexpr double normal_95 = 1.96;
        curve.x_half_width.push_back(normal_95 * uncertainty);
    }
    figure.curves.push_back(std::move(curve));
}

void add_velocity(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure(
        "velocity_profile", "Streamwise velocity",
        record.origin() == Origin::simulated
            ? fmt::format(
                  "Time-mean streamwise velocity over {:.4g} s to {:.4g} s in layers one particle spacing "
                  "thick, averaged over time and along the bed; bars: 95 % intervals of the time mean.",
                  p.window_start, p.window_end)
            : "Time-mean streamwise velocity; bars: 95 % intervals.",
        "thesis, velocity profiles of chapter 4; paper Fig. 2", make_axis("streamwise velocity u", "m/s"));
    Curve simulated =
        profile_curve(own_name(record), record.origin(), p.velocity, p.z, Mark::line_and_points);
    simulated.x_half_width = p.velocity_half_width;
    figure.curves.push_back(std::move(simulated));
    if (record.column() != nullptr)
        figure.curves.push_back(column_curve(record.column()->profile, record.column()->profile.velocity));
    add_measured_points(figure, record.measured());
    analysis.figures.push_back(std::move(figure));
}

void add_gradient(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure("velocity_gradient_profile", "Velocity gradient",
                                   "Time-mean du/dz of the particles, the column's, and that of the measured "
                                   "profile (differences between neighbouring points).",
                                   "thesis chapter 4, du/dz", make_axis("velocity gradient du/dz", "1/s"));
    if (p.velocity_gradient.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no velocity gradient");
        return;
    }
    figure.curves.push_back(profile_curve(own_name(record), record.origin(), p.velocity_gradient, p.z));
    if (record.column() != nullptr) {
        figure.curves.push_back(
            column_curve(record.column()->profile, record.column()->profile.velocity_gradient));
    }
    const FlowRecord::Measured& measured = record.measured();
    if (measured.profile.height.size() > 1) {
        std::vector<double> height;
        std::vector<double> gradient;
        for (const ComparedPoint& point :
             compare_gradients({p.z, p.velocity}, {measured.profile.height, measured.profile.velocity})
                 .points) {
            height.push_back(point.z);
            gradient.push_back(point.measured);
        }
        figure.curves.push_back(profile_curve(measured_curve_name(measured), Origin::measured, gradient,
                                              height, measured.from_law ? Mark::line : Mark::points));
    }
    analysis.figures.push_back(std::move(figure));
}

/// Part of the weight above z that the bed elements between z and the crest carry, per plan area, at the
/// upper edges of the bins, Pa.
std::vector<double> drag_above(const Profiles& p) {
    std::vector<double> result(p.drag.size());
    double sum = 0.0;
    for (std::size_t k = p.drag.size(); k-- > 0;) {
        result[k] = std::abs(sum);
        sum += p.drag[k] * (p.bin_upper[k] - p.bin_lower[k]);
    }
    return result;
}

void add_stresses(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure(
        "stress_profile", "Shear stress and its parts",
        "Shear stress on horizontal planes: viscous and closure part, resolved Reynolds part -rho u'w', part "
        "carried by the pressure forces between particles, their sum; the part of the weight above that the "
        "bed elements carry; the analytic line tau_b (1 - (z - d_h)/(H - d_h)) and the balance with the "
        "drag.",
        "thesis (4.6), stress profiles of chapter 4; paper Figs 3-4", make_axis("shear stress tau", "Pa"));
    const Case& c = *record.flow();
    if ((p.total_stress.empty() && p.reynolds_stress.empty()) || p.bin_upper.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no stresses");
        return;
    }
    const auto add = [&](const char* name, const std::vector<double>& values, int variant) {
        if (values.size() != p.bin_upper.size()) return;
        Curve curve = profile_curve(name, record.origin(), values, p.bin_upper);
        curve.variant = variant;
        figure.curves.push_back(std::move(curve));
    };
    add("total", p.total_stress, 0);
    add("viscous and closure", p.viscous_stress, 1);
    add("resolved Reynolds stress", p.reynolds_stress, 2);
    add("pressure forces of pairs", p.pair_stress, 3);
    if (p.drag.size() == p.z.size() && p.bin_lower.size() == p.z.size())
        add("carried by the bed elements above z", drag_above(p), 4);
    if (!p.analytic_stress.empty()) {
        figure.curves.push_back(
            profile_curve("balance with the bed drag", Origin::column, p.analytic_stress, p.bin_upper));
    }
    const double bed_stress =
        crest_stress(c.fluid.density, c.streamwise_gravity(), c.total_depth(), c.crest());
    if (bed_stress > 0.0) {
        figure.curves.push_back(make_curve("analytic line (4.6)", Origin::theory, Mark::line,
                                           {bed_stress, 0.0}, {c.crest(), c.total_depth()}));
    }
    analysis.figures.push_back(std::move(figure));
}

void add_pressure(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure figure = profile_figure("pressure_profile", "Pressure",
                                   "Time-mean pressure of the particles against the hydrostatic pressure "
                                   "below the mean surface level.",
                                   "thesis chapter 4, pressure", make_axis("pressure p", "Pa"));
    if (p.pressure.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no pressure");
        return;
    }
    const std::vector<double> levels = within_window(record, "mean_level");
    double level = c.total_depth();
    if (!levels.empty()) {
        level = 0.0;
        for (const double each : levels) level += each / static_cast<double>(levels.size());
    }
    const double weight = c.fluid.density * c.normal_gravity();
    std::vector<double> hydrostatic;
    double squares = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < p.z.size(); ++i) {
        hydrostatic.push_back(weight * std::max(0.0, level - p.z[i]));
        const double departure = p.pressure[i] - hydrostatic.back();
        squares += departure * departure;
        most = std::max(most, std::abs(departure));
    }
    figure.curves.push_back(
        profile_curve("simulated", Origin::simulated, p.pressure, p.z, Mark::line_and_points));
    figure.curves.push_back(profile_curve("hydrostatic", Origin::theory, hydrostatic, p.z));
    analysis.figures.push_back(std::move(figure));
    if (level <= 0.0) return;
    const double rms = std::sqrt(squares / static_cast<double>(p.z.size())) / (weight * level);
    Finding finding =
        make_finding(chapter, "pressure_departure_rms",
                     "rms departure of the pressure from hydrostatic over the bottom pressure", "1", rms);
    finding.remark = fmt::format("largest departure {:.3g}", most / (weight * level));
    analysis.findings.push_back(std::move(finding));
}

void add_closure(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure("eddy_viscosity_profile", "Eddy viscosity",
                                   "Time-mean eddy viscosity of the closure, and that of the column twin.",
                                   "thesis (4.2), (2.20), (2.21)", make_axis("eddy viscosity nu_t", "m2/s"));
    if (p.eddy_viscosity.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no eddy viscosity");
        return;
    }
    figure.curves.push_back(profile_curve("simulated", Origin::simulated, p.eddy_viscosity, p.z));
    if (record.column() != nullptr) {
        figure.curves.push_back(
            column_curve(record.column()->profile, record.column()->profile.eddy_viscosity));
    }
    analysis.figures.push_back(std::move(figure));
}

Curve error_curve(std::string name, Origin origin, const ProfileComparison& comparison,
                  double ComparedPoint::*member) {
    std::vector<double> x;
    std::vector<double> z;
    for (const ComparedPoint& point : comparison.points) {
        x.push_back(point.*member);
        z.push_back(point.z);
    }
    return profile_curve(std::move(name), origin, x, z, Mark::line_and_points);
}

/// MSEP above and below 0.25 h_w over the datum, as the thesis states them.
void add_error_findings(const Case& c, const ProfileComparison& velocity, const ProfileComparison& gradient,
                        const std::string& against_what, Analysis& analysis) {
    constexpr double lowest = -std::numeric_limits<double>::infinity();
    const double split = c.datum() + 0.25 * c.channel.depth;
    const auto add = [&](const char* key, const char* label, const char* unit, double value,
                         std::optional<double> thesis, const char* more = "") {
        if (!std::isfinite(value)) return;
        analysis.findings.push_back(against(make_finding(chapter, key, label, unit, value), thesis,
                                            "thesis, 2D simulations", "against: " + against_what + more));
    };
    add("velocity_error_rms", "rms relative departure of u from the measured profile", "1",
        velocity.errors.rms_relative, std::nullopt);
    add("msep_velocity_upper", "MSEP of u above 0.25 h_w over the datum", "%",
        errors_between(velocity.points, split, c.total_depth()).mean_msep, 0.5);
    add("msep_velocity_lower", "MSEP of u below 0.25 h_w over the datum", "%",
        errors_between(velocity.points, lowest, split).mean_msep, 2.5);
    add("msep_gradient_lower", "MSEP of du/dz below 0.25 h_w over the datum", "%",
        errors_between(gradient.points, lowest, split).mean_msep, 12.0);
}

void add_intensities(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure figure = make_figure(chapter, "turbulence_intensity_profile", "Turbulence intensities",
                                "Root mean squares of the resolved velocity fluctuations over the friction "
                                "velocity, with Nezu's curves "
                                "2.30 exp(-z/h), 1.27 exp(-z/h) and, across the flow, 1.63 exp(-z/h). A "
                                "mixing-length closure carries the "
                                "turbulence in its stress; what "
                                "the particles resolve is then far below the curves.",
                                "thesis (2.12)-(2.14)", make_axis("intensity over friction velocity", "1"),
                                make_axis("height above the datum over depth z/h", "1"));
    const double friction_velocity = friction_velocity_of(record);
    if (p.velocity_rms.empty() || p.vertical_velocity_rms.empty() || friction_velocity <= 0.0) {
        add_missing(record, analysis, std::move(figure),
                    "the profiles hold no fluctuations, or no friction velocity is known");
        return;
    }
    const auto add = [&](const char* name, const std::vector<double>& rms, int variant) {
        std::vector<double> x;
        std::vector<double> y;
        for (std::size_t i = 0; i < rms.size(); ++i) {
            x.push_back(rms[i] / friction_velocity);
            y.push_back((p.z[i] - c.datum()) / c.channel.depth);
        }
        Curve curve = make_curve(name, record.origin(), Mark::line_and_points, x, y);
        curve.variant = variant;
        figure.curves.push_back(std::move(curve));
    };
    add("u'", p.velocity_rms, 0);
    add("w'", p.vertical_velocity_rms, 1);
    Curve u = make_curve("Nezu: 2.30 exp(-z/h)", Origin::theory, Mark::line, {}, {});
    Curve w = make_curve("Nezu: 1.27 exp(-z/h)", Origin::theory, Mark::line, {}, {});
    w.variant = 1;
    Curve v = make_curve("Nezu: v' 1.63 exp(-z/h)", Origin::theory, Mark::line, {}, {});
    v.variant = 2;
    constexpr int steps = 40;
    for (int i = 4; i <= steps; ++i) {
        const double xi = static_cast<double>(i) / steps;
        const TurbulenceIntensities law = nezu_intensities(xi, 1.0, 1.0);
        u.x.push_back(law.streamwise);
        w.x.push_back(law.vertical);
        v.x.push_back(law.spanwise);
        v.y.push_back(xi);
        u.y.push_back(xi);
        w.y.push_back(xi);
    }
    figure.curves.push_back(std::move(u));
    figure.curves.push_back(std::move(w));
    figure.curves.push_back(std::move(v));
    analysis.figures.push_back(std::move(figure));
}

/// Departure of u from a reference profile, with the thesis' MSEP.
void add_errors(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
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
    if (measured.profile.height.size() > 1) {
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
            error_curve("velocity gradient", Origin::simulated, gradient, &ComparedPoint::msep));
        square.curves.back().variant = 1;
        add_error_findings(c, velocity, gradient,
                           measured.from_law ? measured_name(c) + ", its log law" : "measured profile",
                           analysis);
    }
    if (record.column() != nullptr && p.velocity_deviation.size() == p.z.size() &&
        p.column_velocity.size() == p.z.size()) {
        std::vector<double> relative;
        for (std::size_t i = 0; i < p.z.size(); ++i) {
            relative.push_back(p.column_velocity[i] != 0.0 ? p.velocity_deviation[i] / p.column_velocity[i]
                                                           : nan);
        }
        error.curves.push_back(profile_curve("against the column twin", Origin::column, relative, p.z));
    }
    if (record.column() != nullptr && record.origin() == Origin::measured) {
        const ColumnProfile& column = record.column()->profile;
        const ProfileComparison beside = compare_profiles({column.z, column.velocity}, {p.z, p.velocity});
        error.curves.push_back(
            error_curve("column twin", Origin::column, beside, &ComparedPoint::relative_error));
        square.curves.push_back(error_curve("column twin", Origin::column, beside, &ComparedPoint::msep));
        if (std::isfinite(beside.errors.mean_msep)) {
            analysis.findings.push_back(make_finding(chapter, "msep_column",
                                                     "MSEP of the column twin's u at the measured points",
                                                     "%", beside.errors.mean_msep));
        }
    }
    const std::string why = measured.note.empty() ? "no measured profile is known: the case names none "
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

}  // namespace

void analyse_profiles(const FlowRecord& record, Analysis& analysis) {
    const Profiles& p = record.profiles();
    if (record.flow() == nullptr) {
        if (p.empty()) return;
        add_velocity(record, p, analysis);
        analysis.warnings.emplace_back(
            "of a profile without its case only the velocity is drawn: --case CASE.toml gives depth, slope "
            "and "
            "datum");
        return;
    }
    if (p.empty() || p.velocity.empty()) {
        add_missing(record, analysis,
                    profile_figure("velocity_profile", "Streamwise velocity", "", "",
                                   make_axis("streamwise velocity u", "m/s")),
                    "the results file holds no profiles of this window: time averages had not started, or "
                    "the window is shorter than a block of 0.1 s");
        return;
    }
    if (!record.measured().note.empty()) analysis.warnings.push_back(record.measured().note);
    add_velocity(record, p, analysis);
    add_gradient(record, p, analysis);
    add_errors(record, p, analysis);
    add_stresses(record, p, analysis);
    add_intensities(record, p, analysis);
    add_pressure(record, p, analysis);
    add_closure(record, p, analysis);
    add_double_averages(record, analysis);
}

}  // namespace riffle
