#include <algorithm>
#include <cmath>

#include "case/bed_friction.hpp"
#include "case/bed_traits.hpp"
#include "case/conversion.hpp"
#include "case/flow_kind.hpp"
#include "case/key_table.hpp"
#include "case/refusals.hpp"
#include "case/sphere_tiling.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

std::string rounded_length_text(double value) { return fmt::format("{:.4f} mm", 1e3 * value); }

bool by_log_law(const Case& c) { return c.side_walls.drag_form == SideDragForm::log_law; }

bool has_periodic_sides(const Case& c) { return c.channel.sides == Sides::periodic; }

/// Two dimensions have no such choice, nor need it: "goes with [channel] dimensions = 3".
CaseCheck in_space_alone(const char* id, std::string_view what, std::string_view why, std::string_view cure,
                         bool (*chosen)(const Case&)) {
    return {{id, "channel.dimensions"}, what, why, cure, [id, chosen](const Case& c) {
                return found_if(chosen(c), "{} = {} goes with [channel] dimensions = 3", find_key(id)->name,
                                value_text(*find_key(id), find_key(id)->get(c)));
            }};
}

/// Three dimensions do not have this choice (yet).
CaseCheck in_a_plane_alone(const char* id, std::string_view what, std::string_view why, std::string_view cure,
                           bool (*chosen)(const Case&)) {
    return {{id, "channel.dimensions"}, what, why, cure, [id, chosen](const Case& c) {
                return found_if(chosen(c), "{} = {} is not there with [channel] dimensions = 3",
                                find_key(id)->name, value_text(*find_key(id), find_key(id)->get(c)));
            }};
}

/// The spheres of a periodic bed repeat in the period of their lattice.
Findings without_tiling(const char* name, double extent, double period, const char* period_text) {
    Findings found =
        found_if(std::abs(extent / (whole_periods(extent, period) * period) - 1.0) > largest_stretch,
                 "{} is {}, and the lattice of the spheres repeats every {} = {}", name, shown_length(extent),
                 period_text, rounded_length_text(period));
    const double below = period * std::max(1.0, std::floor(extent / period));
    for (CaseFinding& finding : found) {
        finding.cure =
            fmt::format("take {} or {}", rounded_length_text(below), rounded_length_text(below + period));
    }
    return found;
}

double edge_zone(const Case& c) { return c.turbulence.edge_zone * 0.5 * c.total_depth(); }

/// Each sphere must be seen by some particles, or its drag depends on where they happen to be.
constexpr double particles_over_sphere = 4.0;

}  // namespace

CheckList plane_refusals() {
    return {{
                in_space_alone(
                    "bed.drag_form", R"(`drag_form = "slice"` or `"plan-mean"` in two dimensions)",
                    "both spread the drag over the plan", "choose \"consistent\", which is its plan mean",
                    [](const Case& c) {
                        return c.bed.drag_form == DragForm::slice || c.bed.drag_form == DragForm::plan_mean;
                    }),
                in_space_alone("start.lattice", "`lattice = \"body-centred\"` in two dimensions",
                               "\"body-centred\" is an arrangement in space",
                               R"(choose "hexagonal", which rests in still water as it does, or "square")",
                               [](const Case& c) { return c.start.lattice == StartLattice::body_centred; }),
                in_space_alone("start.kind", "`kind = \"section\"` in two dimensions",
                               "a plane has no cross-section", "choose \"column\"",
                               [](const Case& c) { return c.start.kind == StartKind::section; }),
            },
            [](const Case& c) { return !in_space(c); }};
}

CheckList space_refusals() {
    return {
        {
            {{"channel.top", "channel.sides"},
             R"(`top = "periodic"` without `sides = "periodic"`)",
             "a box that repeats itself upward does so across as well",
             "choose [channel] sides = \"periodic\"",
             [](const Case& c) { return c.channel.top == Top::periodic && !has_periodic_sides(c); }},
            in_a_plane_alone(
                "bed.drag_form", "`drag_form = \"paper\"` in three dimensions", "it knows no single spheres",
                R"(choose "consistent", "slice" or "thesis")",
                [](const Case& c) { return over_spheres(c) && c.bed.drag_form == DragForm::paper; }),
            in_a_plane_alone(
                "numerics.viscosity",
                R"(a `viscosity` other than `"morris"` in three dimensions with `turbulence.closure = "czernuszenko-rylov"`, `spanwise_ratio` other than 1 and `eddy_stress = "two-point"`)",
                "the closure needs pairs that can be weighed by their direction",
                "choose \"morris\", or spanwise_ratio = 1",
                [](const Case& c) {
                    return c.turbulence.closure == ClosureKind::czernuszenko_rylov &&
                           c.turbulence.spanwise_ratio != 1.0 &&
                           c.numerics.viscosity != ViscosityForm::morris &&
                           c.numerics.eddy_stress == EddyStress::two_point;
                }),
            in_a_plane_alone("turbulence.stress_terms", "`stress_terms = \"shear\"` in three dimensions",
                             "side walls shear the water across the channel too", "choose \"full\"",
                             [](const Case& c) { return c.turbulence.stress_terms == StressTerms::shear; }),
            {{"channel.width", "numerics.spacing"},
             "a simulated width below one kernel support of 2 h, or, between periodic sides, below two with their skin",
             "the kernel must find its place in the water",
             "make the channel wider or the spacing smaller",
             [](const Case& c) {
                 const double needed = has_periodic_sides(c) ? least_period(c) : kernel_support(c);
                 return found_if(c.channel.simulated_width() < needed,
                                 "width: the simulated width is {}, and at least {} is needed",
                                 shown_length(c.channel.simulated_width()), rounded_length_text(needed));
             }},
            {{"start.kind", "channel.sides"},
             R"(`kind = "section"` with `channel.sides = "periodic"`)",
             "between periodic sides the flow does not vary across the channel",
             R"(choose kind = "column", or sides = "walls" or "half")",
             [](const Case& c) { return c.start.kind == StartKind::section && has_periodic_sides(c); }},
        },
        in_space};
}

CheckList sphere_refusals() {
    return {
        {
            {{"bed.sphere_diameter", "channel.width"},
             "`sphere_diameter` above `channel.width` in three dimensions",
             "not one sphere lies on the bed",
             "make the spheres smaller or the channel wider",
             [](const Case& c) {
                 return found_if(c.bed.sphere_diameter > c.channel.width,
                                 "sphere_diameter is {}, wider than the channel ({})",
                                 shown_length(c.bed.sphere_diameter), shown_length(c.channel.width));
             },
             true},
            {{"channel.length", "bed.sphere_diameter"},
             "`length` no whole number of periods of the spheres' lattice, D, in three dimensions",
             "the spheres would not tile the bed",
             "take a whole number of them",
             [](const Case& c) {
                 return without_tiling("length", c.channel.length, lattice_periods(c.bed).x, "D");
             }},
            {{"channel.width", "bed.sphere_diameter"},
             "`width` between periodic sides no whole number of periods of the spheres' lattice, sqrt(3) D with hexagonal packing and D with square",
             "the spheres would not tile the bed across the channel",
             "take a whole number of them",
             [](const Case& c) {
                 return has_periodic_sides(c)
                            ? without_tiling("width", c.channel.width, lattice_periods(c.bed).y,
                                             c.bed.packing == Packing::hexagonal ? "sqrt(3) D" : "D")
                            : Findings{};
             }},
            {{"numerics.spacing", "bed.sphere_diameter"},
             "`spacing` above a quarter of `bed.sphere_diameter` in three dimensions",
             "so few particles do not resolve the drag of a sphere",
             "make the spacing smaller",
             [](const Case& c) {
                 const double largest = c.bed.sphere_diameter / particles_over_sphere;
                 Findings found = found_if(c.numerics.spacing > largest,
                                           "spacing is {}: less than {:.0f} particles over a sphere of {}",
                                           shown_length(c.numerics.spacing), particles_over_sphere,
                                           shown_length(c.bed.sphere_diameter));
                 for (CaseFinding& finding : found) {
                     finding.cure = fmt::format("make the spacing {} or less", shown_length(largest));
                 }
                 return found;
             }},
            {{"bed.sphere_ramp"},
             "`sphere_ramp` above `sphere_diameter`",
             "the drag of a sphere sets in around its surface",
             "give at most the diameter",
             [](const Case& c) {
                 return found_if(c.sphere_ramp() > c.bed.sphere_diameter,
                                 "sphere_ramp is {}, more than the sphere diameter {}",
                                 shown_length(c.sphere_ramp()), shown_length(c.bed.sphere_diameter));
             }},
        },
        [](const Case& c) { return in_space(c) && over_spheres(c); }};
}

CheckList side_wall_refusals() {
    return {
        {
            {{"side_walls.drag_form", "bed.kind"},
             R"(`drag_form = "consistent"` over a bed without drag)",
             "the drag of the side walls follows from that of the bed, and this bed has none",
             R"(choose drag_form = "log-law" or "none")",
             [](const Case& c) {
                 return c.side_walls.drag_form == SideDragForm::consistent && !has_log_law(c);
             },
             true},
            {{"side_walls.drag_form", "bed.kind"},
             R"(`drag_form = "thesis"` without `bed.kind = "spheres"`)",
             "it is made of the drag coefficient of the spheres",
             R"(choose drag_form = "log-law", "consistent" or "none")",
             [](const Case& c) { return c.side_walls.drag_form == SideDragForm::thesis && !over_spheres(c); },
             true},
            {{"side_walls.drag_form", "bed.kind"},
             R"(`drag_form = "log-law"` with `bed.kind = "no-slip"`)",
             "the water rests at the side walls too, and their friction would count twice",
             R"(choose drag_form = "none", or another bed)",
             [](const Case& c) { return by_log_law(c) && is_no_slip(c.bed); },
             true},
            {{"side_walls.drag_form", "turbulence.closure"},
             R"(`drag_form = "log-law"` with `turbulence.closure = "none"`)",
             "laminar flow has no log law",
             R"(choose a closure, or drag_form = "none")",
             [](const Case& c) { return by_log_law(c) && !has_closure(c); },
             true},
            {{"side_walls.equivalent_roughness", "fluid.kinematic_viscosity"},
             "smooth side walls by the log law without viscosity",
             "the friction of a smooth wall is that of its viscous layer",
             "give the viscosity of the water, 1e-6, or an equivalent_roughness of the walls",
             [](const Case& c) {
                 return by_log_law(c) && c.fluid.kinematic_viscosity <= 0.0 &&
                        c.side_walls.equivalent_roughness.value_or(has_roughness(c.bed) ? 1.0 : 0.0) <= 0.0;
             },
             true},
            {{"side_walls.equivalent_roughness", "side_walls.layer"},
             "`equivalent_roughness` of the side walls above their `layer`",
             "the log law begins far from the roughness",
             "make the layer thicker, or the roughness smaller",
             [](const Case& c) {
                 const double roughness =
                     c.side_walls.equivalent_roughness.value_or(c.bed.equivalent_roughness.value_or(0.0));
                 return found_if(by_log_law(c) && roughness > c.side_layer(),
                                 "equivalent_roughness is {}, the layer {} thick", shown_length(roughness),
                                 shown_length(c.side_layer()));
             }},
            {{"side_walls.layer", "numerics.spacing"},
             "`layer` below `numerics.spacing`",
             "hardly a particle would feel the drag of the wall",
             "make it thicker or the spacing smaller",
             [](const Case& c) {
                 return found_if(c.side_layer() < c.numerics.spacing,
                                 "layer is {}, thinner than the spacing {}", shown_length(c.side_layer()),
                                 shown_length(c.numerics.spacing));
             }},
            {{"side_walls.layer", "turbulence.edge_zone"},
             "`layer` above `turbulence.edge_zone` H / 2 with `turbulence.closure = \"czernuszenko-rylov\"`",
             "the drag of a wall acts where the wall makes the mixing lengths smaller",
             "make it thinner, or edge_zone larger",
             [](const Case& c) {
                 return found_if(
                     c.turbulence.closure == ClosureKind::czernuszenko_rylov && c.side_layer() > edge_zone(c),
                     "layer is {}, thicker than the edge zone of the mixing lengths, edge_zone H / 2 = {}",
                     shown_length(c.side_layer()), rounded_length_text(edge_zone(c)));
             }},
            {{"side_walls.layer", "channel.width"},
             "`layer` above a quarter of `channel.width`",
             "the layers of both walls would fill more than half of the channel",
             "make it thinner, or where it is not given, and three spacings then, numerics.spacing smaller",
             [](const Case& c) {
                 return found_if(c.side_layer() > 0.25 * c.channel.width, "layer is {}, the channel {} wide",
                                 shown_length(c.side_layer()), shown_length(c.channel.width));
             }},
        },
        [](const Case& c) { return c.has_side_wall_drag(); }};
}

}  // namespace riffle::inline case_file
