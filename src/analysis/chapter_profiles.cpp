// Vertical profiles of the time means: velocity and its gradient, stresses, turbulence intensities, pressure.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "analysis/section_parts.hpp"
#include "hydraulics/profile_comparison.hpp"
#include "hydraulics/turbulence_laws.hpp"
#include "roughness/bed_drag.hpp"

namespace riffle {

namespace {

constexpr const char* chapter = "profiles";
constexpr double normal_95 = 1.96;  ///< half-width of a 95 % interval over the standard uncertainty

const char* own_name(const FlowRecord& record) {
    return record.origin() == Origin::simulated ? "simulated" : "measured";
}

/// A curve of the column twin, thinned to what a figure can show.
Curve column_curve(const ColumnProfile& column, const std::vector<double>& values) {
    constexpr std::size_t most = 300;
    return profile_curve("column twin", Origin::column, thinned(values, most), thinned(column.z, most));
}

/// Whether the profiles of a run are means over a width with side walls: neither the column twin, of a wide
/// channel, nor what was measured at the centreline is like them.
bool between_side_walls(const FlowRecord& record) {
    return record.origin() == Origin::simulated && record.flow() != nullptr &&
           record.flow()->has_side_walls();
}

/// The twin beside a profile over the whole plan: the column's, between side walls the section's mean over
/// the width.
void add_twin(const FlowRecord& record, const std::vector<double> ColumnProfile::*of_column,
              const std::vector<double> SectionTwin::*of_section, Figure& figure) {
    if (!between_side_walls(record)) {
        if (record.column() != nullptr)
            figure.curves.push_back(
                column_curve(record.column()->profile, record.column()->profile.*of_column));
        return;
    }
    const SectionTwin& twin = record.section_twin();
    if (twin.empty() || of_section == nullptr) return;
    figure.curves.push_back(profile_curve(
        "section twin, mean over the width", Origin::column,
        twin_profile(twin, twin.*of_section, Strip{0.0, record.flow()->channel.simulated_width()}), twin.z));
}

void add_measured_points(Figure& figure, const FlowRecord::Measured& measured) {
    if (measured.profile.height.empty()) return;
    Curve curve = profile_curve(measured_curve_name(measured), Origin::measured, measured.profile.velocity,
                                measured.profile.height, measured.from_law ? Mark::line : Mark::points);
    for (const double uncertainty : measured.profile.uncertainty)
        curve.x_half_width.push_back(normal_95 * uncertainty);
    figure.curves.push_back(std::move(curve));
}

/// A further measured quantity times a factor, with its 95 % half-widths where the file of the profile gives
/// its uncertainty. Nothing where it was not measured, or not over the width that the profiles are means of.
void add_measured_turbulence(const FlowRecord& record, ProfileQuantity quantity,
                             std::vector<double> Profiles::*values, std::string name, double factor,
                             int variant, Figure& figure) {
    const FlowRecord::Measured& measured = record.measured();
    const std::vector<double>& of = measured.turbulence.*values;
    if (of.empty() || between_side_walls(record)) return;
    const ProfileColumn* const column = measured.file ? measured.file->find(quantity) : nullptr;
    const bool uncertain = column != nullptr && column->uncertainty.size() == of.size();
    // The Reynolds stress is in Pa here and in m2/s2 in the file.
    const double of_file = quantity == ProfileQuantity::reynolds_stress ? record.flow()->fluid.density : 1.0;
    Curve curve = make_curve(std::move(name), Origin::measured, Mark::points, {}, {}, variant);
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (!std::isfinite(of[i])) continue;
        curve.x.push_back(factor * of[i]);
        curve.y.push_back(measured.turbulence.z[i]);
        if (uncertain)
            curve.x_half_width.push_back(std::abs(factor * of_file) * normal_95 * column->uncertainty[i]);
    }
    if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
}

/// What the profiles of a run are means over beside time.
std::string bed_plane(const FlowRecord& record) {
    if (record.flow() == nullptr || record.flow()->channel.dimensions == 2) return "along the bed";
    return record.flow()->has_side_walls() ? "over the whole plan, side walls and all; what was measured at "
                                             "the centreline stands beside the "
                                             "centreline's profile, in the chapter on the cross-section"
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
    add_twin(record, &ColumnProfile::velocity, &SectionTwin::velocity, figure);
    if (!between_side_walls(record)) add_measured_points(figure, record.measured());
    mark_levels(record, figure);
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
    add_twin(record, &ColumnProfile::velocity_gradient, nullptr, figure);
    const FlowRecord::Measured& measured = record.measured();
    if (measured.profile.height.size() > 1 && !between_side_walls(record)) {
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
    mark_levels(record, figure);
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
    add_measured_turbulence(record, ProfileQuantity::reynolds_stress, &Profiles::reynolds_stress,
                            "measured -rho u'w'", 1.0, 0, figure);
    const double bed_stress =
        crest_stress(c.fluid.density, c.streamwise_gravity(), c.total_depth(), c.crest());
    if (bed_stress > 0.0) {
        figure.curves.push_back(make_curve("analytic line (4.6)", Origin::theory, Mark::line,
                                           {bed_stress, 0.0}, {c.crest(), c.total_depth()}));
    }
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
}

/// Mean level of the surface over the window of the profiles; the depth where none was recorded.
double mean_level_of(const FlowRecord& record, const Profiles& p) {
    const auto time = record.series().find("time");
    const auto level = record.series().find("mean_level");
    double sum = 0.0;
    double count = 0.0;
    if (time != record.series().end() && level != record.series().end()) {
        for (std::size_t i = 0; i < time->second.size(); ++i) {
            if (time->second[i] < p.window_start || time->second[i] > p.window_end ||
                !std::isfinite(level->second[i])) {
                continue;
            }
            sum += level->second[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : record.flow()->total_depth();
}

/// Whether the water of a flow that nothing drives stands level on the average of the profiles' window, so
/// that its layers have one depth.
bool is_level(const FlowRecord& record, const Profiles& p) {
    const SpaceTime& surface = record.surface();
    const double depth = record.flow()->total_depth();
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = 0; i < surface.columns; ++i) {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t row = 0; row < surface.rows(); ++row) {
            if (surface.times[row] < p.window_start || surface.times[row] > p.window_end) continue;
            sum += surface.at(row, i);
            count += 1.0;
        }
        if (!(count > 0.0) || !std::isfinite(sum)) return false;
        low = std::min(low, sum / count);
        high = std::max(high, sum / count);
    }
    constexpr double tolerance = 0.02;
    return high - low < tolerance * depth;
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
    const double level = mean_level_of(record, p);
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
    mark_levels(record, figure);
    analysis.figures.push_back(std::move(figure));
    if (!(weight * level > 0.0)) return;
    Figure departure =
        profile_figure("pressure_departure_profile", "Departure of the pressure from hydrostatic",
                       "Time-mean pressure of the particles less the hydrostatic pressure below the mean "
                       "surface level, over "
                       "that at the bed level.",
                       "", make_axis("pressure departure over bottom pressure", "1"));
    std::vector<double> share;
    for (std::size_t i = 0; i < p.z.size(); ++i)
        share.push_back((p.pressure[i] - hydrostatic[i]) / (weight * level));
    departure.curves.push_back(
        profile_curve("simulated", Origin::simulated, share, p.z, Mark::line_and_points));
    departure.curves.push_back(
        make_curve("hydrostatic", Origin::theory, Mark::line, {0.0, 0.0}, {0.0, level}));
    mark_levels(record, departure);
    analysis.figures.push_back(std::move(departure));
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
    add_twin(record, &ColumnProfile::eddy_viscosity, nullptr, figure);
    mark_levels(record, figure);
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
    const std::size_t measured_first = figure.curves.size();
    add_measured_turbulence(record, ProfileQuantity::streamwise_rms, &Profiles::velocity_rms, "measured u'",
                            1.0 / of_measured, 0, figure);
    add_measured_turbulence(record, ProfileQuantity::vertical_rms, &Profiles::vertical_velocity_rms,
                            "measured w'", 1.0 / of_measured, 1, figure);
    add_measured_turbulence(record, ProfileQuantity::spanwise_rms, &Profiles::spanwise_velocity_rms,
                            "measured v'", 1.0 / of_measured, 2, figure);
    for (std::size_t i = measured_first; i < figure.curves.size(); ++i) {
        for (double& z : figure.curves[i].y) z = (z - c.datum()) / c.channel.depth;
    }
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
    if (record.origin() == Origin::simulated && record.flow() != nullptr &&
        is_undriven(flow_kind(*record.flow()))) {
        // Layers of a flow that changes in time and place have no mean worth the name, but still water has.
        if (!p.empty() && is_level(record, p)) add_pressure(record, p, analysis);
        return;
    }
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
