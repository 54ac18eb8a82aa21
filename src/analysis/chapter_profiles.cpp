// Vertical profiles of the time means: velocity and its gradient, stresses, turbulence intensities, pressure.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "hydraulics/profile_comparison.hpp"
#include "hydraulics/turbulence_laws.hpp"
#include "roughness/bed_drag.hpp"

namespace riffle {

namespace {

constexpr const char* chapter = "profiles";

const char* own_name(const FlowRecord& record) {
    return record.origin() == Origin::simulated ? "simulated" : "measured";
}

/// A curve of the column twin, thinned to what a figure can show.
Curve column_curve(const ColumnProfile& column, const std::vector<double>& values) {
    constexpr std::size_t most = 300;
    return profile_curve("column twin", Origin::column, thinned(values, most), thinned(column.z, most));
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

/// What the profiles of a run are means over beside time.
std::string bed_plane(const FlowRecord& record) {
    if (record.flow() == nullptr || record.flow()->channel.dimensions == 2) return "along the bed";
    return record.flow()->has_side_walls()
               ? "over the whole plan, side walls and all (the measured profile is the centreline's)"
               : "over the whole plan";
}

void add_velocity(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure = profile_figure(
        "velocity_profile", "Streamwise velocity",
        record.origin() == Origin::simulated
            ? fmt::format(
                  "Time-mean streamwise velocity over {:.4g} s to {:.4g} s in layers one particle spacing "
                  "thick, averaged over time and {}; bars: 95 % intervals of the time mean.",
                  p.window_start, p.window_end, bed_plane(record))
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
        figure.curves.push_back(make_curve(name, record.origin(), Mark::line, values, p.bin_upper, variant));
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
    const Profiles& measured = record.measured().turbulence;
    if (!measured.reynolds_stress.empty()) {
        figure.curves.push_back(profile_curve("measured -rho u'w'", Origin::measured,
                                              measured.reynolds_stress, measured.z, Mark::points));
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

/// The mixing length: of the particles what their eddy viscosity and gradient come to, and that of the
/// column.
void add_mixing_length(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    Figure figure =
        profile_figure("mixing_length_profile", "Mixing length",
                       "Mixing length of the closure: of the run sqrt(nu_t/|du/dz|) of its mean "
                       "profiles, and that of the column twin.",
                       "paper Fig. 3; thesis (4.2), (2.20), (2.21)", make_axis("mixing length l_m", "m"));
    const bool has = p.eddy_viscosity.size() == p.z.size() && p.velocity_gradient.size() == p.z.size();
    if (!has || record.flow()->turbulence.closure == ClosureKind::none) {
        add_missing(record, analysis, std::move(figure),
                    "the profiles hold no eddy viscosity or no velocity gradient");
        return;
    }
    std::vector<double> length;
    for (std::size_t i = 0; i < p.z.size(); ++i)
        length.push_back(std::sqrt(p.eddy_viscosity[i] / std::abs(p.velocity_gradient[i])));
    figure.curves.push_back(
        profile_curve("simulated", Origin::simulated, length, p.z, Mark::line_and_points));
    if (record.column() != nullptr) {
        figure.curves.push_back(
            column_curve(record.column()->profile, record.column()->profile.mixing_length));
    }
    analysis.figures.push_back(std::move(figure));
}

/// The drag term of the momentum equation.
void add_drag(const FlowRecord& record, const Profiles& p, Analysis& analysis) {
    const Case& c = *record.flow();
    if (c.bed.kind != BedKind::spheres) return;
    Figure figure =
        profile_figure("drag_profile", "Drag term of the bed",
                       "Drag of the bed's elements on the water per mass, tau_d/rho, against the "
                       "flow; of the column twin at its velocity.",
                       "paper Fig. 2c; thesis (4.3)-(4.4)", make_axis("drag term tau_d/rho", "m/s2"));
    if (p.drag.size() != p.z.size() || p.drag.empty()) {
        add_missing(record, analysis, std::move(figure), "the profiles hold no drag");
        return;
    }
    std::vector<double> term;
    for (const double drag : p.drag) term.push_back(drag / c.fluid.density);
    figure.curves.push_back(profile_curve("simulated", Origin::simulated, term, p.z, Mark::line_and_points));
    const auto law = make_bed_drag(c);
    if (record.column() != nullptr && law != nullptr) {
        const ColumnProfile& column = record.column()->profile;
        std::vector<double> of_column;
        for (std::size_t i = 0; i < column.z.size(); ++i)
            of_column.push_back(-law->coefficient(column.z[i]) * column.velocity[i] *
                                std::abs(column.velocity[i]));
        figure.curves.push_back(column_curve(column, of_column));
    }
    analysis.figures.push_back(std::move(figure));
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
    const Profiles& measured = record.measured().turbulence;
    const bool none = p.velocity_rms.empty() && p.vertical_velocity_rms.empty() &&
                      p.spanwise_velocity_rms.empty() && measured.velocity_rms.empty() &&
                      measured.vertical_velocity_rms.empty() && measured.spanwise_velocity_rms.empty();
    if (none || friction_velocity <= 0.0) {
        add_missing(record, analysis, std::move(figure),
                    "the profiles hold no fluctuations, or no friction velocity is known");
        return;
    }
    const auto add = [&](const std::string& name, Origin origin, const Profiles& from,
                         const std::vector<double>& rms, double scale, int variant) {
        if (rms.empty()) return;
        std::vector<double> x;
        std::vector<double> y;
        for (std::size_t i = 0; i < rms.size(); ++i) {
            x.push_back(rms[i] / scale);
            y.push_back((from.z[i] - c.datum()) / c.channel.depth);
        }
        figure.curves.push_back(make_curve(
            name, origin, origin == record.origin() ? Mark::line_and_points : Mark::points, x, y, variant));
    };
    add("u'", record.origin(), p, p.velocity_rms, friction_velocity, 0);
    add("w'", record.origin(), p, p.vertical_velocity_rms, friction_velocity, 1);
    add("v'", record.origin(), p, p.spanwise_velocity_rms, friction_velocity, 2);
    // What was measured is scaled with its own friction velocity.
    const double of_measured = c.measured.friction_velocity.value_or(friction_velocity);
    add("measured u'", Origin::measured, measured, measured.velocity_rms, of_measured, 0);
    add("measured w'", Origin::measured, measured, measured.vertical_velocity_rms, of_measured, 1);
    add("measured v'", Origin::measured, measured, measured.spanwise_velocity_rms, of_measured, 2);
    const auto add_law = [&](const char* name, double TurbulenceIntensities::*component, int variant) {
        Curve curve = make_curve(name, Origin::theory, Mark::line, {}, {}, variant);
        constexpr int steps = 40;
        for (int i = 4; i <= steps; ++i) {
            const double xi = static_cast<double>(i) / steps;
            curve.x.push_back(nezu_intensities(xi, 1.0, 1.0).*component);
            curve.y.push_back(xi);
        }
        figure.curves.push_back(std::move(curve));
    };
    add_law("Nezu: 2.30 exp(-z/h)", &TurbulenceIntensities::streamwise, 0);
    add_law("Nezu: 1.27 exp(-z/h)", &TurbulenceIntensities::vertical, 1);
    add_law("Nezu: v' 1.63 exp(-z/h)", &TurbulenceIntensities::spanwise, 2);
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

Figure profile_figure(std::string key, std::string title, std::string caption, std::string source, Axis x) {
    return make_figure(chapter, std::move(key), std::move(title), std::move(caption), std::move(source),
                       std::move(x), make_axis("height above the bed level z", "m"));
}

Curve profile_curve(std::string name, Origin origin, const std::vector<double>& values,
                    const std::vector<double>& z, Mark mark) {
    return make_curve(std::move(name), origin, mark, values, z);
}

std::string measured_curve_name(const FlowRecord::Measured& measured) {
    return measured.from_law ? "measured: rough log law (2.3) of its u* and ks" : "measured";
}

void analyse_profiles(const FlowRecord& record, Analysis& analysis) {
    const Profiles& p = record.profiles();
    if (record.flow() == nullptr) {
        if (p.empty()) return;
        add_velocity(record, p, analysis);
        if (!record.velocity_grids().empty()) add_plane_maps(record, analysis);
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
    add_profile_errors(record, p, analysis);
    add_stresses(record, p, analysis);
    add_intensities(record, p, analysis);
    add_pressure(record, p, analysis);
    add_closure(record, p, analysis);
    if (record.origin() == Origin::simulated) {
        add_mixing_length(record, p, analysis);
        add_drag(record, p, analysis);
    }
    add_double_averages(record, analysis);
    add_plane_maps(record, analysis);
}

}  // namespace riffle
