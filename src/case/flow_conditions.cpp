#include "case/flow_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "case/bed_traits.hpp"
#include "case/case_text.hpp"
#include "case/key.hpp"
#include "case/nearest.hpp"
#include "case/presets.hpp"

namespace riffle::inline case_file {

namespace {

/// A row of Table 3.1 of the thesis, SI, with the roughness height of its 2D simulations.
struct FlowCondition {
    double depth;
    double velocity;  ///< U, depth mean on the centreline
    double friction_velocity;
    double discharge;
    double slope;
    double equivalent_roughness;
    double diameters;          ///< d_h / D
    double surface_deviation;  ///< 0: not measured
};

constexpr std::array<FlowCondition, 8> conditions{{
    {0.040, 0.28, 0.039, 0.008, 0.004, 0.035, 0.40, 0.00032},
    {0.050, 0.35, 0.044, 0.011, 0.004, 0.035, 0.40, 0.00040},
    {0.060, 0.26, 0.034, 0.010, 0.002, 0.030, 0.40, 0.0},
    {0.070, 0.33, 0.037, 0.013, 0.002, 0.028, 0.40, 0.0},
    {0.070, 0.36, 0.045, 0.016, 0.003, 0.030, 0.40, 0.00115},
    {0.080, 0.42, 0.048, 0.021, 0.003, 0.028, 0.32, 0.0},
    {0.090, 0.47, 0.051, 0.024, 0.003, 0.026, 0.32, 0.0},
    {0.100, 0.43, 0.044, 0.023, 0.002, 0.022, 0.32, 0.00150},
}};

constexpr double longest_run = 240.0;
constexpr std::size_t not_uniform = 4;  ///< the condition that the thesis dropped

Case rough_bed() {
    Case c;
    c.title = "Flow over a bed of spheres";
    c.channel.slope = 0.004;
    c.channel.depth = 0.050;
    c.bed.roughness_height = Diameters{0.4}.length(c.bed.sphere_diameter);
    c.run.time = longest_run;
    choose_resolution(c, {});
    return c;
}

Case flow_condition(std::size_t number) {
    const FlowCondition& row = conditions[number - 1];
    Case c = rough_bed();
    c.title =
        fmt::format("Flow condition {}: depth {:.0f} mm, slope {}", number, row.depth * 1000, row.slope);
    c.channel.slope = row.slope;
    c.channel.depth = row.depth;
    c.bed.roughness_height = Diameters{row.diameters}.length(c.bed.sphere_diameter);
    choose_resolution(c, {});
    c.measured.depth_mean_velocity = row.velocity;
    c.measured.friction_velocity = row.friction_velocity;
    c.measured.equivalent_roughness = row.equivalent_roughness;
    c.measured.discharge = row.discharge;
    if (row.surface_deviation > 0) c.measured.surface_standard_deviation = row.surface_deviation;
    c.measured.uniform = number != not_uniform;
    c.measured.source = "thesis, Table 3.1";
    return c;
}

/// A three-dimensional run of a condition: the numerics of docs/theory.md for three dimensions.
Case space_condition(std::size_t number, double spacing) {
    Case c = flow_condition(number);
    c.channel.dimensions = 3;
    c.turbulence.closure = ClosureKind::czernuszenko_rylov;
    c.numerics = preset_numerics(Preset::riffle, 3);
    c.numerics.spacing = spacing;
    c.start.lattice = StartLattice::square;
    return c;
}

/// At the size of the thesis' three-dimensional runs, 3 H long as nearly as the spheres tile it.
Case thesis_space_condition(std::size_t number) {
    Case c = space_condition(number, number <= 2 ? 0.0015 : 0.0025);
    c.title += ", in three dimensions";
    const double diameter = c.bed.sphere_diameter;
    c.channel.length = Diameters{std::round(3.0 * c.total_depth() / diameter)}.length(diameter);
    c.channel.sides = Sides::walls;
    c.run.time = 120.0;
    c.start.kind = StartKind::section;
    c.output.snapshot_interval = 5.0;
    c.output.snapshot_fields = "velocity";
    return c;
}

/// Half of the channel's width and two spheres long, for minutes on a laptop.
Case coarse_space_condition(std::size_t number) {
    // As many rows among the crests as the shallow conditions need: at 4 mm they run 4 % fast.
    Case c = space_condition(number, number <= 2 ? 0.003 : 0.004);
    c.title += ", in three dimensions, coarse";
    c.channel.length = 2.0 * c.bed.sphere_diameter;
    c.channel.sides = Sides::half;
    c.start.kind = StartKind::section;
    c.run.time = 60.0;
    c.output.mean_field_interval = 2.0;
    return c;
}

/// A cell of two by one periods of the spheres' lattice, part of a wide channel.
Case wide_space_condition(std::size_t number) {
    Case c = space_condition(number, 0.003);
    c.title += ", in three dimensions, wide channel";
    c.channel.length = 2.0 * c.bed.sphere_diameter;
    c.channel.width = 0.0433;
    c.run.time = 60.0;
    c.output.mean_field_interval = 2.0;
    return c;
}

struct SpaceFamily {
    std::string_view suffix;
    Case (*make)(std::size_t number);
};
constexpr std::array<SpaceFamily, 3> space_families{{{"-3d", thesis_space_condition},
                                                     {"-3d-coarse", coarse_space_condition},
                                                     {"-3d-wide", wide_space_condition}}};
constexpr std::array<std::size_t, 4> space_conditions{1, 2, 5, 8};  ///< those of the thesis

/// Geometry and closure as the paper states them, heights from its bed level at -8 mm.
Case paper() {
    Case c = rough_bed();
    c.title = "The case of the 2016 paper: depth 50 mm, slope 0.004";
    c.bed.sphere_diameter = 0.024;
    c.bed.roughness_height = 0.012;
    c.bed.drag_coefficient = 0.5;
    c.bed.drag_form = DragForm::paper;
    c.turbulence.closure = ClosureKind::nezu_rodi;
    c.turbulence.zero = 0.0045;
    c.turbulence.wake_strength = 0.0;
    c.turbulence.stress_terms = StressTerms::shear;
    // No eddy viscosity at the bed keeps the lowest rows in order; the hexagonal lattice does better there.
    c.start.lattice = StartLattice::hexagonal;
    c.numerics.spacing = 0.002;
    c.numerics.smoothing_ratio = 2.1;
    c.numerics.wall_layers = 5;
    return c;
}

/// A cell of condition 2 whose eddies the particles carry: three depths long, two lattice periods of the
/// spheres wide.
Case resolved_eddies() {
    Case c = flow_condition(2);
    c.title = "Resolved eddies over a bed of spheres: a cell of flow condition 2";
    c.channel.dimensions = 3;
    c.channel.sides = Sides::periodic;
    c.channel.length = 0.15;
    c.channel.width = 2.0 * std::sqrt(3.0) * c.bed.sphere_diameter;
    c.numerics = preset_numerics(Preset::riffle, 3);
    // 20 over the depth: at 3 mm the noise of the particles may take the stress from the eddies.
    c.numerics.spacing = 0.0025;
    c.numerics.smoothing_ratio = 1.5;
    c.numerics.wall_layers = 3;
    choose_for_resolved_eddies(c);
    c.start.kind = StartKind::power_law;
    c.start.velocity = 0.4;
    c.start.jitter = 0.1;
    c.run.until = RunUntil::time;
    c.run.time = 24.0;
    c.run.average_from = 10.0;
    c.output.snapshot_interval = 0.5;
    c.output.surface_map_interval = 0.05;
    c.output.mean_field_interval = 2.0;
    return c;
}

/// Water that breaks against the far wall of a tank, in the proportions of Buchner (2002) and Lobovsky et al.
/// (2014).
Case dam_break() {
    Case c;
    c.title = "Dam break against a wall: 0.3 m of water in a tank of 1.61 m";
    c.channel.depth = 0.3;
    c.channel.length = 1.61;
    c.channel.ends = Ends::walls;
    c.channel.wall_height = 0.6;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.turbulence.closure = ClosureKind::none;
    c.numerics = preset_numerics(Preset::violent);
    c.numerics.spacing = 0.005;
    c.start.kind = StartKind::rest;
    c.start.water_x = {0.0, 0.6, 0.6, 0.0};
    c.start.water_z = {0.0, 0.0, 0.3, 0.3};
    c.run.until = RunUntil::time;
    c.run.time = 3.0;
    c.output.series_interval = 0.005;
    c.output.snapshot_interval = 0.05;
    Probe gauges;
    gauges.name = "wall_pressure";
    gauges.kind = ProbeKind::pressure;
    gauges.sampling_frequency = 1500.0;
    gauges.x = {1.61};
    gauges.z = {0.003, 0.015, 0.03, 0.04, 0.06, 0.08};
    c.probes = {gauges};
    return c;
}

}  // namespace

std::vector<std::string> builtin_case_names() {
    std::vector<std::string> names{"rough-bed", "dam-break", "resolved-eddies"};
    for (std::size_t number = 1; number <= conditions.size(); ++number) {
        names.push_back(fmt::format("condition-{}", number));
    }
    names.emplace_back("paper-2016");
    for (const SpaceFamily& family : space_families) {
        for (const std::size_t number : space_conditions) {
            names.push_back(fmt::format("condition-{}{}", number, family.suffix));
        }
    }
    return names;
}

Case builtin_case(std::string_view name) {
    const auto names = builtin_case_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        const auto meant = nearest_name(name, names);
        throw InputError(
            fmt::format("`{}` is neither a case file nor a built-in case{}; the built-in cases are {}", name,
                        meant ? fmt::format(": did you mean {}?", *meant) : "", fmt::join(names, ", ")));
    }
    Case c;
    if (name == "rough-bed") {
        c = rough_bed();
    } else if (name == "dam-break") {
        c = dam_break();
    } else if (name == "resolved-eddies") {
        c = resolved_eddies();
    } else if (name == "paper-2016") {
        c = paper();
    } else {
        const auto number = static_cast<std::size_t>(name[std::string_view("condition-").size()] - '0');
        const std::string_view suffix = name.substr(std::string_view("condition-0").size());
        const auto* const family = std::find_if(space_families.begin(), space_families.end(),
                                                [&](const SpaceFamily& f) { return f.suffix == suffix; });
        c = family == space_families.end() ? flow_condition(number) : family->make(number);
    }
    c.text = case_text(c);
    return c;
}

std::optional<int> flow_condition_of(const Case& c) {
    constexpr double close = 1e-6;  // m, and of the slope: cases are written with four digits
    if (!has_spheres(c.bed) || std::abs(c.bed.sphere_diameter - Bed{}.sphere_diameter) > close) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        if (std::abs(c.channel.depth - conditions[i].depth) < close &&
            std::abs(c.channel.slope - conditions[i].slope) < close) {
            return static_cast<int>(i) + 1;
        }
    }
    return std::nullopt;
}

}  // namespace riffle::inline case_file
