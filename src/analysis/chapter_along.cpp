// The flow along a channel with bodies: bed, bodies, level and energy line over x.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "analysis/along_parts.hpp"
#include "analysis/bodies.hpp"
#include "analysis/chapters.hpp"
#include "analysis/drowned_inflow.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/flood_passage.hpp"
#include "analysis/pools.hpp"
#include "analysis/tailwater_passage.hpp"
#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "case/cross_section.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/porous_zone.hpp"
#include "column/canal_flow.hpp"
#include "ends/end_input.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

/// Velocity and discharge of a canal beside those of its hydraulic radius.
void add_canal(const FlowRecord& record, const CanalFlow& canal, Analysis& analysis) {
    const auto add = [&](const char* key, const char* label, const char* unit, std::vector<double> values,
                         double factor, double law) {
        if (values.size() < 2) return;
        for (double& value : values) value *= factor;
        const MeanEstimate mean = mean_with_confidence(values);
        Finding finding =
            make_finding(chapters::along, key, label, unit, mean.mean, trusted_half_width(mean));
        const std::string radius = fmt::format("hydraulic radius {:.4g} mm", 1e3 * canal.hydraulic_radius);
        if (canal.alone) {
            finding = against(std::move(finding), law, "Colebrook and White", radius);
        } else {
            finding.remark =
                radius +
                "; the equation of Colebrook and White knows no stems or stones, and is no reference here";
        }
        analysis.findings.push_back(std::move(finding));
    };
    add("canal_velocity", "mean velocity of the canal's water", "m/s",
        within_window(record, fields::time_series.total_mean_velocity), 1.0, canal.velocity);
    add("canal_discharge", "discharge of the canal", "m3/s", discharge_of(record),
        record.flow()->channel.whole_over_simulated(), canal.discharge);
}

/// Whether a body lies on the water at a place, or less than three spacings above it, as a bridge deck does
/// that the water reaches: there the level is that of a closed section, and says nothing of the pressure in
/// it.
bool is_covered(const std::vector<Outline>& bodies, double x, double level, double spacing) {
    if (!std::isfinite(level)) return false;
    const auto solid = [&](double spacings) {
        return std::any_of(bodies.begin(), bodies.end(), [&](const Outline& body) {
            return contains(body, x, level + spacings * spacing);
        });
    };
    return !solid(-1.0) && (solid(1.0) || solid(2.0) || solid(3.0));
}

void add_extreme(const LongProfile& profile, bool highest, Analysis& analysis) {
    std::size_t at = profile.x.size();
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
        if (!std::isfinite(profile.level[i]) || profile.covered[i]) continue;
        const bool further = at == profile.x.size() || (highest ? profile.level[i] > profile.level[at]
                                                                : profile.level[i] < profile.level[at]);
        if (further) at = i;
    }
    if (at == profile.x.size()) return;
    Finding finding =
        make_finding(chapters::along, highest ? "highest_level" : "lowest_level",
                     highest ? "highest mean level along the channel" : "lowest mean level along the channel",
                     "m", profile.level[at], profile.half_width[at]);
    finding.remark = fmt::format("above the bed level, at x = {}", shown_place(profile.x[at]));
    if (profile.covered_somewhere()) {
        finding.remark += "; but for where a body lies on the water";
    }
    analysis.findings.push_back(std::move(finding));
}

/// Velocities and heads of the mean flow, as far as one discharge per width gives them: in two dimensions.
struct Heads {
    std::vector<double> velocity, froude, energy, critical;
};

Heads heads_of(const Case& c, const LongProfile& profile, const std::vector<Outline>& bodies,
               double discharge) {
    Heads heads;
    const double gravity = c.normal_gravity();
    const double critical_depth = std::cbrt(discharge * discharge / gravity);
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
        const double blocked = std::isfinite(profile.level[i])
                                   ? blocked_height(bodies, profile.x[i], profile.level[i])
                                   : not_a_number;
        const double depth = profile.level[i] - blocked;
        const double velocity = depth > 0.0 ? discharge / depth : not_a_number;
        heads.velocity.push_back(velocity);
        heads.froude.push_back(profile.covered[i] ? not_a_number : velocity / std::sqrt(gravity * depth));
        heads.energy.push_back(profile.covered[i] ? not_a_number
                                                  : profile.level[i] + velocity * velocity / (2.0 * gravity));
        heads.critical.push_back(blocked + critical_depth);
    }
    return heads;
}

void add_velocity(const LongProfile& profile, const Heads& heads, Analysis& analysis) {
    Figure velocity =
        make_figure(chapters::along, "velocity_along", "Mean velocity along the channel",
                    "Discharge per unit width over the height of the water that bodies leave free.", "",
                    make_axis("distance along the channel x", "m"), make_axis("velocity q/h", "m/s"));
    velocity.y.from = 0.0;
    velocity.curves.push_back(
        make_curve("simulated", Origin::simulated, Mark::line, profile.x, heads.velocity));
    analysis.figures.push_back(std::move(velocity));
    Figure froude =
        make_figure(chapters::along, "froude_along", "Froude number along the channel",
                    "Mean velocity over the celerity of long waves on the water's height; above 1 the flow "
                    "is supercritical.",
                    "", make_axis("distance along the channel x", "m"), make_axis("Froude number Fr", "1"));
    froude.y.from = 0.0;
    froude.curves.push_back(make_curve("simulated", Origin::simulated, Mark::line, profile.x, heads.froude));
    froude.guides.push_back({"critical", false, 1.0, 1.0});
    analysis.figures.push_back(std::move(froude));
    double most = 0.0;
    for (const double value : heads.froude) most = std::isfinite(value) ? std::max(most, value) : most;
    analysis.findings.push_back(make_finding(chapters::along, "largest_froude",
                                             "largest Froude number along the channel", "1", most));
}

/// The curve of steady varied flow between what the ends give, beside the levels, and how far off they are.
void compare_with_varied_flow(const FlowRecord& record, const LongProfile& profile, Figure& figure,
                              Analysis& analysis) {
    const Case& c = *record.flow();
    if (has_solids_beside_section(c) || varies_beyond_beds(c) || !channel_or_walls_resist(c) ||
        resolves_eddies(c) || !c.inflow_unit_discharge()) {
        return;
    }
    std::vector<double> depth;
    try {
        const auto varied = varied_depths(c, read_end_levels(c));
        for (const double x : profile.x) depth.push_back(varied(x));
    } catch (const Error& error) {
        analysis.warnings.push_back(std::string("no steady varied flow to compare with: ") + error.what());
        return;
    }
    figure.curves.push_back(
        make_curve("steady varied flow (riffle backwater)", Origin::theory, Mark::line, profile.x, depth, 2));
    double most = 0.0;
    double at = 0.0;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const double share = (profile.level[i] - depth[i]) / depth[i];
        if (std::isfinite(share) && std::abs(share) > std::abs(most)) {
            most = share;
            at = profile.x[i];
        }
    }
    Finding finding = make_finding(
        chapters::along, "backwater_departure",
        "largest departure of the mean level from steady varied flow, over its depth", "1", most);
    finding.remark = fmt::format("at x = {}", shown_place(at));
    analysis.findings.push_back(std::move(finding));
}

/// Discharge that leaves a channel of open ends: what enters, less the growth of the mass that it holds, in
/// means over a hundredth of the record each.
Curve leaving_discharge(const FlowRecord& record) {
    const SeriesTable& series = record.series();
    const auto& of = fields::time_series;
    const auto& time = series[of.time];
    const auto& entering = series[of.inflow_discharge];
    const auto& stored = series[of.mass_stored];
    constexpr std::size_t parts = 100;
    constexpr std::size_t fewest = 10;  // particles leave in bunches
    const std::size_t step = std::max(fewest, time.size() / parts);
    std::vector<double> middle;
    std::vector<double> leaving;
    for (std::size_t first = 0; first + step < time.size(); first += step) {
        const std::size_t last = first + step;
        const double duration = time[last] - time[first];
        const double growth = (stored[last] - stored[first]) / (record.flow()->fluid.density * duration);
        const double mean =
            std::accumulate(&entering[first], &entering[last], 0.0) / static_cast<double>(step);
        middle.push_back(0.5 * (time[first] + time[last]));
        leaving.push_back(mean - growth);
    }
    return make_curve("outflow, by the particles", Origin::simulated, Mark::line, middle, leaving, 2);
}

/// What crosses the ends, and how deep the water is there.
void add_ends(const FlowRecord& record, Analysis& analysis) {
    const SeriesTable& series = record.series();
    const auto& of = fields::time_series;
    if (!series.has(of.inflow_discharge)) return;
    constexpr std::size_t most = 3000;
    const std::vector<double> time = thinned(series[of.time], most);
    const bool space = record.flow()->channel.dimensions == 3;
    const double whole = record.flow()->channel.whole_over_simulated();
    Figure discharge = make_figure(
        chapters::along, "end_discharges", "Discharge at the ends",
        fmt::format(
            "What enters the channel, what the section at the outflow carries, and what leaves by the account of "
            "the particles, in means over a hundredth of the run each{}.",
            whole > 1.0 ? "; all twice that of the simulated half" : ""),
        "", make_axis("time t", "s"),
        space ? make_axis("discharge", "m3/s") : make_axis("discharge per unit width", "m2/s"));
    Figure depth = make_figure(chapters::along, "end_depths", "Depth at the ends",
                               "Height of the water over the bed level of the sections that rule the ends.",
                               "", make_axis("time t", "s"), make_axis("depth", "m"));
    const auto add = [&](Figure& figure, const char* label, const Field& field, int variant) {
        figure.curves.push_back(
            make_curve(label, Origin::simulated, Mark::line, time, thinned(series[field], most), variant));
    };
    add(discharge, "inflow", of.inflow_discharge, 0);
    add(discharge, "section at the outflow", of.outflow_discharge, 1);
    if (series.has(of.mass_stored)) discharge.curves.push_back(leaving_discharge(record));
    for (Curve& curve : discharge.curves) {
        for (double& value : curve.y) value *= whole;
    }
    add(depth, "inflow", of.inflow_depth, 0);
    add(depth, "outflow", of.outflow_depth, 1);
    analysis.figures.push_back(std::move(discharge));
    analysis.figures.push_back(std::move(depth));
}

}  // namespace

void analyse_along(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || record.origin() != Origin::simulated) return;
    const Case& c = *record.flow();
    const bool space = c.channel.dimensions == 3;
    const bool changing = changes_at_ends(c);
    Figure figure = make_figure(
        chapters::along, "long_profile", "Long profile",
        fmt::format(
            "Bed{} and the time mean of the surface along the {}, above the bed level, which falls "
            "with the slope {:.4g}; band: 95 % interval of the mean; dashes: lowest and highest recorded "
            "level.",
            space ? ""
            : std::any_of(c.solids.begin(), c.solids.end(), std::mem_fn(&Solid::is_free))
                ? ", bodies, free ones where they stand at the end,"
                : ", bodies",
            space ? "centreline" : "channel", c.channel.slope),
        "", make_axis("distance along the channel x", "m"), make_axis("height above the bed level z", "m"));
    figure.x.from = 0.0;
    figure.x.to = c.channel.length;
    figure.y.from = 0.0;
    const std::optional<CanalFlow> canal = canal_flow(c);
    if (canal) add_canal(record, *canal, analysis);
    const SpaceTime& surface = record.surface();
    if (surface.rows() < 2) {
        add_missing(record, analysis, std::move(figure),
                    "the results file holds no record of the surface in the window");
        return;
    }
    LongProfile profile = long_profile(surface);
    const std::vector<Outline> bodies = prescribed_outlines_at(c, record.window().from);
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
        profile.covered.push_back(is_covered(bodies, profile.x[i], profile.level[i], c.numerics.spacing));
    }
    for (Curve& body : body_curves(record, record.window().from, record.window().to)) {
        figure.curves.push_back(std::move(body));
    }
    Curve level = make_curve("mean level", Origin::simulated, Mark::line, profile.x, profile.level);
    // A band where each place has enough independent samples for one.
    if (std::all_of(profile.half_width.begin(), profile.half_width.end(),
                    [](double half_width) { return std::isfinite(half_width); })) {
        level.y_half_width = profile.half_width;
    }
    figure.curves.push_back(std::move(level));
    figure.curves.push_back(
        make_curve("lowest level", Origin::reference, Mark::line, profile.x, profile.lowest, 1));
    figure.curves.push_back(
        make_curve("highest level", Origin::reference, Mark::line, profile.x, profile.highest, 2));

    if (c.channel.ends == Ends::open && !changing) {
        compare_with_varied_flow(record, profile, figure, analysis);
    }

    const std::optional<UnitDischarge> discharge = canal ? std::nullopt : unit_discharge(record);
    std::optional<Heads> heads;
    if (discharge) {
        if (uneven_bed_of(c) != nullptr) {
            const double width = c.channel.width;
            std::optional<double> half_width = discharge->half_width;
            if (half_width) *half_width *= width;
            analysis.findings.push_back(make_finding(chapters::along, "discharge", "discharge", "m3/s",
                                                     width * discharge->mean, half_width));
        } else {
            analysis.findings.push_back(make_finding(chapters::along, "unit_discharge",
                                                     "discharge per unit width", "m2/s", discharge->mean,
                                                     discharge->half_width));
        }
        if (find_at_end(record, fields::flow_rate.flow_rate, 1) != nullptr) {
            analysis.findings.back().remark = changing ? "at the inflow, mean over the window"
                                              : space
                                                  ? "at the inflow"
                                                  : "at the inflow; velocity, Froude number and energy line "
                                                    "take it all along the channel, as in steady flow";
        }
        if (discharge->drift != 0.0) {
            std::string& remark = analysis.findings.back().remark;
            remark += fmt::format(
                "{}it changes by {:+.2g} % over the window, more than chance: the flow is not "
                "steady, and its mean has no interval",
                remark.empty() ? "" : "; ", 100.0 * discharge->drift);
        }
    }
    const bool drowned = !changing && add_drowned_inflow(record, analysis);
    // The means of a flood or a tide belong to no one discharge; over a jet under a roller q/h is no
    // velocity.
    const double steady = discharge.value_or(UnitDischarge{}).mean;
    if (steady > 0.0 && !space && !changing && !drowned) {
        heads = heads_of(c, profile, bodies, steady);
        figure.curves.push_back(make_curve("energy line, level + (q/h)²/(2g)", Origin::simulated, Mark::line,
                                           profile.x, heads->energy, 1));
        figure.curves.push_back(
            make_curve("critical level", Origin::theory, Mark::line, profile.x, heads->critical, 1));
        figure.caption +=
            " The energy line and the critical level take one velocity over the height of the water, q/h.";
        if (profile.covered_somewhere()) {
            figure.caption +=
                " Where a body lies on the water there is no energy line: the pressure there is not that of a level.";
        }
    }
    if (drowned && !space) {
        figure.caption +=
            " A roller lies on the jet at the inflow, where q/h is no velocity: no energy line is drawn.";
    }
    analysis.figures.push_back(std::move(figure));
    if (!changing) {
        add_extreme(profile, true, analysis);
        add_extreme(profile, false, analysis);
    }
    if (heads) add_velocity(profile, *heads, analysis);
    if (steady > 0.0 && !changing) add_pools(record, profile, steady, analysis);
    add_flood_passage(record, analysis);
    add_tailwater_passage(record, analysis);
    if (c.channel.ends == Ends::open) add_ends(record, analysis);
}

}  // namespace riffle::inline analysis
