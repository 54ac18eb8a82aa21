// Laws fitted to the velocity profile, and the channel numbers that follow from the mean velocity.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/fit_parts.hpp"
#include "analysis/section_parts.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "hydraulics/law_fits.hpp"
#include "hydraulics/log_law.hpp"
#include "solver/summary.hpp"

namespace riffle::inline analysis {

namespace {

Figure laws_figure(const FlowRecord& record, const FittedFlow& flow) {
    Figure figure =
        make_figure(chapters::fits, "fitted_laws", "Laws fitted to the velocity profile",
                    "Velocity profile with the fitted laws, each drawn over the range of heights that "
                    "it was fitted to. Zero plane: the datum.",
                    "thesis (2.3), (2.5), (2.24)-(2.26)", make_axis("streamwise velocity u", "m/s"),
                    make_axis("height above the bed level z", "m"));
    figure.curves.push_back(make_curve(record.origin() == Origin::simulated ? "simulated" : "measured",
                                       record.origin(), Mark::points,
                                       {flow.points.velocity.begin(), flow.points.velocity.end()},
                                       {flow.points.z.begin(), flow.points.z.end()}));
    return figure;
}

/// u/u_* over (z - z_0)/k_s of a profile above its zero plane.
Curve scaled_profile(const char* name, Origin origin, const VelocityPoints& points, double friction_velocity,
                     double roughness) {
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < points.z.size(); ++i) {
        const double height = points.z[i] - points.zero_plane;
        if (height <= 0.0) continue;
        x.push_back(height / roughness);
        y.push_back(points.velocity[i] / friction_velocity);
    }
    return make_curve(name, origin, Mark::points, x, y);
}

void add_log_law(const FlowRecord& record, const FittedFlow& flow, Figure& laws, Analysis& analysis) {
    const Case& c = *record.flow();
    Figure figure = make_figure(
        chapters::fits, "log_law", "Rough log law",
        "Velocity over the friction velocity against the height over the datum, scaled with the fitted "
        "roughness; the line is u/u* = ln((z - z0)/ks)/0.41 + 8.5.",
        "thesis (2.3)", make_axis("height over roughness (z - z0)/ks", "1", true),
        make_axis("velocity u/u*", "1"));
    const LogLawFit fit = fit_log_law(flow.points, log_law_kappa, flow.log_law_range);
    if (!fit.valid) {
        warn_of_failure(analysis, "rough log law", fit);
        add_missing(record, analysis, std::move(figure),
                    "the rough log law could not be fitted: " + fit.why_not);
        return;
    }
    const auto value = [](double best, double half_width, const Interval& interval) {
        return FittedValue{best, half_width, interval};
    };
    analysis.findings.push_back(against(
        fitted(
            "log_law_friction_velocity", "friction velocity u*, log-law fit", "m/s",
            value(fit.friction_velocity, fit.friction_velocity_half_width, fit.friction_velocity_interval)),
        c.measured.friction_velocity, measured_name(c)));
    analysis.findings.push_back(
        against_roughness(fitted("equivalent_roughness", "equivalent sand roughness ks, log-law fit", "m",
                                 value(fit.equivalent_roughness, fit.equivalent_roughness_half_width,
                                       fit.equivalent_roughness_interval)),
                          c));
    analysis.findings.push_back(make_finding(chapters::fits, "log_law_residual",
                                             "rms residual of the log law", "m/s", fit.residual_rms));
    const LogLawFit free = fit_log_law_with_zero_plane(flow.points, log_law_kappa, flow.log_law_range);
    // Heights are known to half a spacing.
    const double known = 0.5 * c.numerics.spacing;
    if (free.valid && (free.zero_plane < -known || free.zero_plane > c.crest() + known)) {
        analysis.warnings.push_back(
            fmt::format("rough log law with a free zero plane: the fit puts it {:.3g} mm {} the datum, "
                        "{}; it and what follows from it are left out",
                        1000.0 * std::abs(free.zero_plane - flow.points.zero_plane),
                        free.zero_plane < flow.points.zero_plane ? "below" : "above",
                        free.zero_plane < 0.0 ? "below the bed"
                        : has_rough_bed(c)    ? "above the crests"
                                              : "above the bed"));
    } else if (free.valid) {
        analysis.findings.push_back(
            against(fitted("zero_plane", "zero plane of the log law, fitted, above the datum", "m",
                           value(free.zero_plane - flow.points.zero_plane, free.zero_plane_half_width,
                                 {free.zero_plane_interval.lower - flow.points.zero_plane,
                                  free.zero_plane_interval.upper - flow.points.zero_plane})),
                    0.0, "datum",
                    fmt::format("{}; the interval takes the residuals of the points as independent",
                                has_rough_bed(c) ? "between bed level and crests, to half a spacing"
                                                 : "at the bed level, to half a spacing")));
        analysis.findings.push_back(fitted("zero_plane_friction_velocity",
                                           "u* with the zero plane fitted, too", "m/s",
                                           value(free.friction_velocity, free.friction_velocity_half_width,
                                                 free.friction_velocity_interval)));
        analysis.findings.push_back(
            fitted("zero_plane_equivalent_roughness", "ks with the zero plane fitted, too", "m",
                   value(free.equivalent_roughness, free.equivalent_roughness_half_width,
                         free.equivalent_roughness_interval)));
    } else {
        warn_of_failure(analysis, "rough log law with a free zero plane", free);
    }
    figure.curves.push_back(scaled_profile(record.origin() == Origin::simulated ? "simulated" : "measured",
                                           record.origin(), flow.points, fit.friction_velocity,
                                           fit.equivalent_roughness));
    const FlowRecord::Measured& measured = record.measured();
    if (record.column() != nullptr && !c.has_side_walls()) {
        // The twin over the simulated scales, so that differences stay visible.
        const ColumnProfile& column = record.column()->profile;
        constexpr std::size_t most = 300;
        Curve twin = scaled_profile(
            "column twin", Origin::column,
            {thinned(column.z, most), thinned(column.velocity, most), {}, flow.points.zero_plane},
            fit.friction_velocity, fit.equivalent_roughness);
        twin.mark = Mark::line;
        figure.curves.push_back(std::move(twin));
    }
    if (!measured.from_law && !measured.profile.height.empty() && c.measured.friction_velocity &&
        c.measured.equivalent_roughness) {
        const VelocityPoints points{
            measured.profile.height, measured.profile.velocity, {}, flow.points.zero_plane};
        figure.curves.push_back(scaled_profile("measured profile", Origin::measured, points,
                                               *c.measured.friction_velocity,
                                               *c.measured.equivalent_roughness));
    }
    figure.guides.push_back({"fitted range", true,
                             (fit.from - flow.points.zero_plane) / fit.equivalent_roughness,
                             (fit.to - flow.points.zero_plane) / fit.equivalent_roughness});
    const double low = std::max(0.02, (fit.from - flow.points.zero_plane) / fit.equivalent_roughness);
    const double high = flow.depth / fit.equivalent_roughness;
    figure.curves.push_back(make_curve("rough log law (2.3)", Origin::theory, Mark::line, {low, high},
                                       {rough_log_law(low, 1.0, 1.0), rough_log_law(high, 1.0, 1.0)}));
    analysis.figures.push_back(std::move(figure));
    laws.curves.push_back(law_curve("rough log law", 0, flow, fit, [&](double height) {
        return rough_log_law(height, fit.friction_velocity, fit.equivalent_roughness);
    }));
    const double k_plus = roughness_reynolds_number(fit.equivalent_roughness, fit.friction_velocity,
                                                    c.fluid.kinematic_viscosity);
    Finding rough = make_finding(chapters::fits, "roughness_reynolds_number",
                                 "roughness Reynolds number ks u*/nu", "1", k_plus);
    const RoughnessClass kind = roughness_class(k_plus);
    rough.remark = kind == RoughnessClass::smooth         ? "hydraulically smooth (below 5)"
                   : kind == RoughnessClass::transitional ? "transitionally rough (5 to 70)"
                                                          : "fully rough (above 70)";
    analysis.findings.push_back(std::move(rough));
}

void add_other_laws(const FittedFlow& flow, double viscosity, Figure& laws, Analysis& analysis) {
    const std::string with = flow.friction_velocity ? "u* from the stress" : "u* fitted, too";
    const auto note = [&](Finding finding) {
        finding.remark = with + (finding.remark.empty() ? "" : "; " + finding.remark);
        analysis.findings.push_back(std::move(finding));
    };
    const WakeFit wake =
        fit_wake_strength(flow.points, flow.depth, flow.friction_velocity, log_law_kappa, flow.whole_range);
    if (wake.valid) {
        const double reynolds = wake.friction_velocity.value * flow.depth / viscosity;
        Finding strength = fitted("wake_strength", "Coles' wake strength Pi", "1", wake.wake_strength);
        constexpr double fully_developed_wake = 2000.0;
        if (reynolds > fully_developed_wake) {
            strength =
                against(std::move(strength), wake_strength_of_uniform_flow, "Nezu & Rodi, u* h/nu > 2000");
        } else {
            strength.remark += fmt::format(
                "{}u* h/nu = {:.4g}: Nezu & Rodi's Pi = 0.2 holds above 2000, below it is smaller",
                strength.remark.empty() ? "" : "; ", reynolds);
        }
        note(std::move(strength));
        laws.curves.push_back(law_curve("log-wake law", 1, flow, wake, [&](double height) {
            return rough_log_wake_law(height, flow.depth, wake.friction_velocity.value,
                                      wake.equivalent_roughness.value, wake.wake_strength.value);
        }));
    } else {
        warn_of_failure(analysis, "log-wake law", wake);
    }
    const PowerLawFit power = fit_power_law(flow.points, flow.depth, flow.whole_range);
    if (power.valid) {
        analysis.findings.push_back(
            fitted("power_law_m", "m of the power law u = U_max (z/h)^(1/m)", "1", power.m));
        analysis.findings.push_back(
            fitted("power_law_maximum_velocity", "U_max of the power law", "m/s", power.maximum_velocity));
        laws.curves.push_back(law_curve("power law", 2, flow, power, [&](double height) {
            return power_law(height, flow.depth, power.maximum_velocity.value, power.m.value);
        }));
    } else {
        warn_of_failure(analysis, "power law", power);
    }
    const DipFit dip = fit_dip_modified_log_law(flow.points, flow.depth, flow.friction_velocity,
                                                log_law_kappa, flow.whole_range);
    if (dip.valid) {
        note(against(fitted("dip_parameter", "alpha of the dip-modified log law (2.25)", "1", dip.dip), 0.0,
                     "no dip"));
        laws.curves.push_back(law_curve("dip-modified log law", 3, flow, dip, [&](double height) {
            return dip_modified_log_law(height, flow.depth, dip.friction_velocity.value,
                                        dip.zero_velocity_height.value, dip.dip.value);
        }));
    } else {
        warn_of_failure(analysis, "dip-modified log law", dip);
    }
    const DipFit total =
        fit_total_dip_log_wake_law(flow.points, flow.depth, flow.friction_velocity,
                                   wake_strength_of_uniform_flow, log_law_kappa, flow.whole_range);
    if (total.valid) {
        Finding alpha = against(fitted("total_dip_parameter",
                                       "alpha of the total dip-modified log-wake law (2.26)", "1", total.dip),
                                0.0, "no dip");
        alpha.remark += fmt::format("{}Pi = {:.2g} assumed", alpha.remark.empty() ? "" : "; ",
                                    wake_strength_of_uniform_flow);
        note(std::move(alpha));
        laws.curves.push_back(
            law_curve("total dip-modified log-wake law", 4, flow, total, [&](double height) {
                return total_dip_log_wake_law(height, flow.depth, total.friction_velocity.value,
                                              total.zero_velocity_height.value, total.dip.value,
                                              wake_strength_of_uniform_flow);
            }));
    } else {
        warn_of_failure(analysis, "total dip-modified log-wake law", total);
    }
}

/// Friction velocity of a line of stress, with its half-width.
std::optional<std::pair<double, double>> friction_of(const Case& c, const std::optional<StressLine>& line) {
    if (!line || line->crest_stress <= 0.0) return std::nullopt;
    const double velocity = std::sqrt(line->crest_stress / c.fluid.density);
    return std::pair{velocity, 0.5 * velocity * line->half_width / line->crest_stress};
}

/// Line through the total stress over the height around the centreline; none without a mean field.
std::optional<StressLine> centreline_line(const FlowRecord& record) {
    const Case& c = *record.flow();
    if (record.mean_field().empty()) return std::nullopt;
    const SectionProfile stress =
        strip_profile(record.mean_field(), centreline_strip(c),
                      [&](const FieldSums& s) { return total_stress(s, c.fluid.density, false); });
    return fit_stress_line(c, stress.z, stress.value);
}

/// `at_centreline`: the velocities are those around the centreline of a channel with side walls.
void add_stress_velocity(const FlowRecord& record, bool at_centreline, FittedFlow& flow, Analysis& analysis) {
    const Case& c = *record.flow();
    const auto whole = friction_of(c, fit_stress_line(c, record.profiles()));
    const auto found = at_centreline ? friction_of(c, centreline_line(record)) : whole;
    if (found) {
        flow.friction_velocity = found->first;
        flow.friction_velocity_half_width = found->second;
        std::string remark = c.measured.friction_velocity
                                 ? "measured u* is sqrt(g h_w S0); at the crests the depth above "
                                   "them carries the stress, sqrt(g (h_w - 4 mm) S0)"
                                 : "";
        if (at_centreline) {
            remark += (remark.empty() ? "" : "; ") +
                      std::string("beside the walls stress on upright planes carries a part of the weight");
        }
        analysis.findings.push_back(against(
            make_finding(
                chapters::fits, "friction_velocity",
                fmt::format("friction velocity u*, stress at the {}{}", has_rough_bed(c) ? "crests" : "bed",
                            at_centreline ? " around the centreline" : ""),
                "m/s", found->first, found->second),
            c.measured.friction_velocity, measured_name(c), remark));
    }
    if (at_centreline && whole) {
        analysis.findings.push_back(make_finding(chapters::fits, "width_friction_velocity",
                                                 "the same of the mean stress over the width", "m/s",
                                                 whole->first, whole->second));
    }
}

/// The fits of the section twin's own profile around the centreline: what the run's would be without error.
void add_section_twin_fits(const FlowRecord& record, const FittedFlow& flow, Analysis& analysis) {
    const Case& c = *record.flow();
    const SectionTwin& twin = record.section_twin();
    if (twin.empty()) return;
    const Strip strip = centreline_strip(c);
    const std::vector<double> velocity = twin_profile(twin, twin.velocity, strip);
    const LogLawFit fit =
        fit_log_law(VelocityPoints{twin.z, velocity, {}, c.datum()}, log_law_kappa, flow.log_law_range);
    if (fit.valid) {
        analysis.findings.push_back(make_finding(chapters::fits, "section_twin_log_law_friction_velocity",
                                                 "u* of the section twin at the centreline, log-law fit",
                                                 "m/s", fit.friction_velocity));
        analysis.findings.push_back(make_finding(chapters::fits, "section_twin_equivalent_roughness",
                                                 "ks of the section twin at the centreline, log-law fit", "m",
                                                 fit.equivalent_roughness));
    }
    if (const auto stress =
            friction_of(c, fit_stress_line(c, twin.z, twin_profile(twin, twin.shear_stress, strip)))) {
        analysis.findings.push_back(
            make_finding(chapters::fits, "section_twin_friction_velocity",
                         fmt::format("u* of the section twin at the centreline, stress at the {}",
                                     has_rough_bed(c) ? "crests" : "bed"),
                         "m/s", stress->first));
    }
}

}  // namespace

void analyse_fits(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr) return;
    const Case& c = *record.flow();
    const Profiles& p = record.profiles();
    Figure empty = make_figure(chapters::fits, "log_law", "Rough log law", "", "thesis (2.3)",
                               make_axis("height over roughness (z - z0)/ks", "1", true),
                               make_axis("velocity u/u*", "1"));
    if (p.empty() || p.velocity.empty()) {
        add_missing(record, analysis, std::move(empty), "the results file holds no profiles of this window");
        return;
    }
    if (c.channel.slope <= 0.0 || (!has_rough_bed(c) && !has_roughness(c.bed))) {
        add_missing(
            record, analysis, std::move(empty),
            "the laws of rough beds are fitted to the flow down a slope over spheres, solids that are part of "
            "the bed, or a bed by its roughness, only");
        if (c.channel.slope > 0.0 && channel_or_walls_resist(c)) add_channel_numbers(record, analysis);
        return;
    }
    FittedFlow flow;
    flow.points = {p.z, p.velocity, {}, c.datum()};
    // Between side walls the laws are those of the centreline, as they are fitted to measurements.
    SectionProfile centreline;
    if (c.has_side_walls()) centreline = centreline_velocity_profile(record);
    if (!centreline.z.empty()) {
        flow.points = {centreline.z, centreline.value, {}, c.datum()};
    } else if (c.has_side_walls() && record.origin() == Origin::simulated) {
        analysis.warnings.emplace_back(
            "without windows of the mean field the laws are fitted to the mean over the width between the "
            "side walls, not to the centreline's profile");
    }
    const HeightRange range = log_law_range(c);
    flow.log_law_range = {range.from, range.to};
    flow.depth = c.channel.depth;
    flow.whole_range = {has_rough_bed(c) ? c.crest() : range.from, c.datum() + 0.98 * c.channel.depth};
    add_stress_velocity(record, !centreline.z.empty(), flow, analysis);
    if (!centreline.z.empty()) add_section_twin_fits(record, flow, analysis);
    Figure laws = laws_figure(record, flow);
    add_log_law(record, flow, laws, analysis);
    add_roughness_of_stress(record, flow, analysis);
    add_other_laws(flow, c.fluid.kinematic_viscosity, laws, analysis);
    add_secondary_flow_laws(record, flow, laws, analysis);
    add_kappa(record, flow, analysis);
    analysis.figures.push_back(std::move(laws));
    add_channel_numbers(record, analysis);
}

}  // namespace riffle::inline analysis
