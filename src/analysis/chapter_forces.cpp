// Forces on the bed against the weight of the water down the slope.

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "analysis/bed_parts.hpp"
#include "analysis/body_coefficients.hpp"
#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/gauges.hpp"
#include "analysis/momentum_budget.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "case/porous_zone.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "record/twin_fields.hpp"
#include "roughness/side_wall_partition.hpp"
#include "solver/summary.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

/// A share of the weight component: its series, its name, its share in the column twin.
struct Share {
    Field series;
    const char* key;
    const char* label;
    std::optional<double> column;
    int variant;
};

/// What forces in space are those of.
const char* simulated_part(const Case& c) {
    return c.channel.sides == Sides::half ? "of the simulated half of the channel" : "of the whole channel";
}

/// The share of the side walls by the partition of Yang & Lim.
std::string partition_remark(const Case& c) {
    return fmt::format("{}: {:.4g}", partition_name(c), 1.0 - side_wall_partition(c).bed_share);
}

/// Figure and findings of the scalar instruments of one kind.
void add_instruments(const FlowRecord& record, const char* kind, Figure figure, Analysis& analysis) {
    const Case& c = *record.flow();
    // A section of half of a channel records half of its discharge.
    const double whole = std::string_view(kind) == "flow_rate" ? c.channel.whole_over_simulated() : 1.0;
    // The force normal to the wall carries the weight of the water, a hundred times the others.
    Figure normal = figure;
    normal.key += "_wall_normal";
    normal.title = "Force normal to the walls";
    // And the bodies have their own.
    Figure solids = figure;
    solids.key = "solid_forces";
    solids.title = "Forces on the bodies";
    solids.caption = fmt::format(
        "Forces of the water on each solid, {}: downstream, of that by the pressure on its faces (form "
        "drag), and away from the bed; the weight of still water on their tops is in them.",
        figure.y.unit == "N" ? simulated_part(c) : "per unit width");
    solids.source = "";
    Figure moments = solids;
    moments.key = "solid_moments";
    moments.title = "Moments on the bodies";
    moments.caption = fmt::format(
        "Moments of the water's forces on each solid about a point of it (moment_about, else its centroid), {}, "
        "and those of the pressure on its faces; a positive one about y turns z towards x.",
        figure.y.unit == "N" ? simulated_part(c) : "per unit width");
    moments.y = figure.y.unit == "N" ? make_axis("moment", "N m") : make_axis("moment per unit width", "N");
    const auto is_moment = [](const ScalarProbe& probe) {
        return probe.quantity.rfind("solid_", 0) == 0 && probe.quantity.find("moment_") != std::string::npos;
    };
    constexpr std::size_t most = 3000;
    int variant = 0;
    for (const ScalarProbe& probe : record.scalar_probes()) {
        const std::string& unit = is_moment(probe) ? moments.y.unit : figure.y.unit;
        if (probe.kind != kind || probe.unit != unit || probe.value.size() < 2) continue;
        std::vector<double> value = probe.value;
        for (double& each : value) each *= whole;
        (is_moment(probe)                                     ? moments
         : probe.quantity.rfind("solid_", 0) == 0             ? solids
         : probe.quantity.find("normal") != std::string::npos ? normal
                                                              : figure)
            .curves.push_back(make_curve(probe.label, record.origin(), Mark::line, thinned(probe.time, most),
                                         thinned(value, most), variant++));
        const MeanEstimate mean = mean_with_confidence(value);
        Finding finding = make_finding(chapters::forces, probe.name + "_" + probe.quantity, probe.label,
                                       probe.unit, mean.mean, trusted_half_width(mean));
        finding.remark = "instrument " + probe.name;
        if (whole > 1.0) finding.remark += "; twice what passes the simulated half";
        // Below this it is rounding of a force that does not vary.
        if (mean.standard_deviation > 1e-12 * std::abs(mean.mean)) {
            finding.remark +=
                fmt::format("; standard deviation {:.3g} {}", mean.standard_deviation, probe.unit);
        }
        analysis.findings.push_back(std::move(finding));
    }
    if (!solids.curves.empty()) analysis.figures.push_back(std::move(solids));
    if (!moments.curves.empty()) analysis.figures.push_back(std::move(moments));
    if (!figure.curves.empty()) analysis.figures.push_back(std::move(figure));
    if (!normal.curves.empty()) analysis.figures.push_back(std::move(normal));
}

/// Means of the forces on all solids and of their pressure's part over the weight component, from the first
/// instrument that has them.
void add_solid_shares(const FlowRecord& record, Analysis& analysis) {
    const ScalarProbe* const weight = find_scalar(record, fields::forces.weight_component.name);
    if (weight == nullptr) return;
    const MeanEstimate whole = mean_with_confidence(weight->value);
    if (!(whole.mean > 0.0)) return;
    const auto add = [&](const char* prefix, const char* key, const char* label) {
        std::vector<double> sum;
        for (const ScalarProbe& probe : record.scalar_probes()) {
            if (probe.name != weight->name || probe.quantity.rfind(prefix, 0) != 0 ||
                probe.value.size() != weight->value.size()) {
                continue;
            }
            sum.resize(probe.value.size(), 0.0);
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += probe.value[i];
        }
        if (sum.empty()) return;
        const MeanEstimate mean = mean_with_confidence(sum);
        Finding share =
            make_finding(chapters::forces, key, label, "1", mean.mean / whole.mean, trusted_half_width(mean));
        if (share.half_width) *share.half_width /= whole.mean;
        analysis.findings.push_back(std::move(share));
    };
    const bool bodies = has_bodies(*record.flow());
    add("solid_force_", "solid_force_share",
        bodies ? "force on the bodies over the weight component"
               : "force on the solids of the bed over the weight component");
    add("solid_form_drag_", "solid_form_drag_share",
        bodies ? "form drag of the bodies over the weight component"
               : "form drag of the solids of the bed over the weight component");
}

}  // namespace

void analyse_forces(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || record.origin() != Origin::simulated) return;
    const Case& c = *record.flow();
    const bool in_space = c.channel.dimensions == 3;
    add_gauges(record, analysis);
    add_instruments(
        record, "force",
        make_figure(chapters::forces, "force_instruments",
                    record.flow() != nullptr && !record.flow()->solids.empty()
                        ? "Forces on bed, walls and solids"
                        : "Forces on bed and walls",
                    fmt::format("Forces between the water and its bed and walls, and the weight component "
                                "down the slope, {}, as the instruments recorded them.",
                                in_space ? simulated_part(c) : "per unit width"),
                    "thesis (2.16), (4.3)", make_axis("time t", "s"),
                    in_space ? make_axis("force", "N") : make_axis("force per unit width", "N/m")),
        analysis);
    add_instruments(
        record, "flow_rate",
        make_figure(
            chapters::forces, "flow_rate_history", "Flow rate through sections",
            fmt::format("Discharge {}through the sections of the instruments{}.",
                        in_space ? "" : "per unit width ",
                        c.channel.whole_over_simulated() > 1.0 ? ", twice that of the simulated half" : ""),
            "", make_axis("time t", "s"),
            in_space ? make_axis("discharge", "m3/s") : make_axis("discharge per unit width", "m2/s")),
        analysis);
    Figure figure = make_figure(
        chapters::forces, "force_history", "Forces on the water",
        fmt::format(
            "Drag of the bed elements, streamwise force of the walls{}{}{}{}",
            c.has_side_walls() ? ", drag of the side walls" : "",
            c.vegetation.empty() ? "" : ", drag of the vegetation",
            c.porous.empty() ? "" : ", resistance of porous zones",
            c.channel.ends == Ends::open
                ? ", each over the weight component down the slope."
                : " and rate of change of the momentum, each over the weight component down the slope. "
                  "Their sum is one where the momentum is balanced."),
        "thesis (2.16), (4.3), bed stress of chapter 4", make_axis("time t", "s"),
        make_axis("force over weight component", "1"));
    if (is_undriven(flow_kind(c))) return;
    add_body_coefficients(record, analysis);
    add_momentum_budget(record, analysis);
    add_solid_shares(record, analysis);
    const SeriesTable& series = record.series();
    const std::vector<double>& time = series[fields::time_series.time];
    if (time.empty() || c.channel.slope <= 0.0) {
        add_missing(record, analysis, std::move(figure),
                    c.channel.slope <= 0.0 ? "the channel has no slope, so no weight acts along it"
                                           : "the results file holds no time series");
        return;
    }
    std::optional<double> drag_share;
    std::optional<double> wall_share;
    std::optional<double> vegetation_share;
    std::optional<double> porous_share;
    const SectionTwin& twin = record.section_twin();
    const char* const twin_name = c.has_side_walls() ? "section twin" : "column twin";
    if (c.has_side_walls()) {
        drag_share = twin.value(fields::section_numbers.drag_share);
        wall_share = twin.value(fields::section_numbers.wall_share);
        if (!c.vegetation.empty()) vegetation_share = twin.value(fields::section_numbers.vegetation_share);
        if (!c.porous.empty()) porous_share = twin.value(fields::section_numbers.porous_share);
    } else if (record.column() != nullptr) {
        drag_share = record.column()->drag_share;
        wall_share = record.column()->wall_force_share;
        vegetation_share = record.column()->vegetation_share;
        porous_share = record.column()->porous_share;
    }
    constexpr std::size_t most = 3000;
    const double bed_weight =
        c.fluid.density * c.streamwise_gravity() * c.total_depth();  // per plan area, the whole depth
    const std::vector<double> volume = within_window(record, fields::time_series.water_volume);
    std::vector<double> sum_of_forces;
    bool complete = true;
    const auto& of = fields::time_series;
    std::vector<Share> shares = {
        {of.drag_over_gravity, "bed_drag_share", "bed drag over the weight component", drag_share, 0},
        {of.wall_over_gravity, "wall_force_share", "wall force over the weight component", wall_share, 1}};
    // Between open ends momentum comes and goes with the water: its budget tells (momentum_budget.cpp).
    const bool open = c.channel.ends == Ends::open;
    if (!open) {
        shares.push_back({of.acceleration_over_gravity, "acceleration_share",
                          "rate of change of the momentum over the weight component", 0.0, 2});
    }
    if (c.has_side_wall_drag()) {
        shares.push_back({of.side_wall_over_gravity, "side_wall_share",
                          "drag of the side walls over the weight component",
                          twin.value(fields::section_numbers.side_wall_share), 3});
    }
    if (!c.vegetation.empty()) {
        shares.push_back({of.vegetation_over_gravity, "vegetation_share",
                          "drag of the vegetation over the weight component", vegetation_share, 4});
    }
    if (!c.porous.empty()) {
        shares.push_back({of.porous_over_gravity, "porous_share",
                          "resistance of porous zones over the weight component", porous_share, 5});
    }
    for (const Share& share : shares) {
        if (!series.has(share.series)) continue;
        figure.curves.push_back(make_curve(share.label, Origin::simulated, Mark::line, thinned(time, most),
                                           thinned(series[share.series], most), share.variant));
        const std::vector<double> window = within_window(record, share.series);
        if (window.size() < 2) continue;
        const MeanEstimate mean = mean_with_confidence(window);
        const std::optional<double> half_width = trusted_half_width(mean);
        // The shares move against each other: their sum row by row has its own scatter.
        complete = complete && (sum_of_forces.empty() || sum_of_forces.size() == window.size());
        sum_of_forces.resize(window.size(), 0.0);
        for (std::size_t i = 0; i < window.size(); ++i) sum_of_forces[i] += window[i];
        analysis.findings.push_back(against(
            make_finding(chapters::forces, share.key, share.label, "1", mean.mean, half_width), share.column,
            share.variant == 2 ? "steady flow" : twin_name, share.variant == 3 ? partition_remark(c) : ""));
        // Only beds of spheres have a drag of elements.
        const std::optional<double> drag_per_area = bed_stress_of_weight(c, window, volume);
        if (share.variant == 0 && has_spheres(c.bed) && drag_per_area) {
            std::optional<double> expected;
            if (drag_share && !open) expected = *drag_share * bed_weight;
            std::string remark =
                open
                    ? "mean along the channel"
                    : "under the whole depth H down to the bed level, whose water weighs more than that above "
                      "the datum";
            if (c.measured.friction_velocity) {
                remark += fmt::format("; rho u*^2 = {:.4g} Pa above the datum, {}",
                                      c.fluid.density * std::pow(*c.measured.friction_velocity, 2),
                                      measured_name(c));
            }
            Finding stress =
                make_finding(chapters::forces, "bed_stress", "drag of the bed elements per plan area", "Pa",
                             *drag_per_area, half_width);
            if (stress.half_width) *stress.half_width *= std::abs(*drag_per_area / mean.mean);
            analysis.findings.push_back(
                against(std::move(stress), expected,
                        fmt::format("rho g S0 H times the {}'s drag share", twin_name), remark));
        }
    }
    if (figure.curves.empty()) {
        add_missing(record, analysis, std::move(figure), "the time series hold no forces");
        return;
    }
    if (!open) {
        figure.curves.push_back(
            make_curve("balance", Origin::theory, Mark::line, {time.front(), time.back()}, {1.0, 1.0}));
    }
    mark_window(record, figure);
    analysis.figures.push_back(std::move(figure));
    if (sum_of_forces.size() < 2 || open) return;
    if (!complete) {
        analysis.warnings.emplace_back(
            "the time series of the forces have gaps at different times: their balance is left out");
        return;
    }
    if (record.flow() && porosity_varies_along(*record.flow())) {
        analysis.warnings.emplace_back(
            "porous zones end along the channel, where the pressure pushes their grains as well, which is not "
            "recorded: the sum of the forces is not held against the weight");
        return;
    }
    const MeanEstimate balance = mean_with_confidence(sum_of_forces);
    analysis.findings.push_back(
        against(make_finding(chapters::forces, "momentum_balance", "sum of the forces over the weight", "1",
                             balance.mean, trusted_half_width(balance)),
                1.0, "momentum balance"));
}

}  // namespace riffle::inline analysis
