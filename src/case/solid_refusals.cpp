#include <algorithm>

#include "case/bed_friction.hpp"
#include "case/cross_section.hpp"
#include "case/end_floor.hpp"
#include "case/flow_kind.hpp"
#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/solid_places.hpp"
#include "case/surface_roughness.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

bool by_log_law(const Solid& solid) { return solid.surface == SolidSurface::log_law; }

Findings outline_that_fills_all(const Case& c, const Solid& solid) {
    const auto covers = [&](double share) {
        return contains({solid.x, solid.z}, share * c.channel.length, share * c.total_depth());
    };
    return found_if(covers(0.5) && covers(1e-3) && covers(0.999) && c.start.water_x.empty(),
                    "fills the whole channel");
}

/// Whether there may be water on one side alone of an outline that is so thick behind the middle of its edge
/// i: what lies on the bed may taper off.
bool lies_on_wall(const Case& c, const Outline& outline, std::size_t i, double thickness) {
    const EdgeMiddle edge = middle_of_edge(outline, i);
    const auto may_be_water = [&](double inward) {
        return is_in_channel(c, {edge.x + inward * edge.inward_x, 0.0, edge.z + inward * edge.inward_z});
    };
    const double beyond = 1e-6 * c.numerics.spacing;
    return may_be_water(thickness + beyond) != may_be_water(-beyond);
}

/// Water on one side must not reach water on the other, and the layers of wall particles need room.
Findings thin_outline(const Case& c, const Solid& solid) {
    const Outline outline{solid.x, solid.z};
    const bool passes = passes_through(c, solid);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto [left, right] = std::minmax(outline.x[i], outline.x[outline.next(i)]);
        if (passes && (right <= 0.0 || left >= c.channel.length)) {
            continue;  // beyond the ends there is no water
        }
        const double thickness = thickness_at(outline, i);
        const bool tapers = solid.rests() && lies_on_wall(c, outline, i, thickness);
        if (thickness < wall_thickness(c) * (1 - 1e-9) && !tapers) {
            return found_if(
                true,
                "is {} thick behind the middle of its edge from {} to {}, thinner than {} layers of wall particles ({})",
                shown_length(thickness), corner_text(outline, i), corner_text(outline, outline.next(i)),
                c.numerics.wall_layers, shown_length(wall_thickness(c)));
        }
    }
    return {};
}

}  // namespace

CheckList solid_refusals() {
    return {{
        {{"solid.x", "start.water_x"},
         "more than 20 000 corners in all outlines",
         "each edge is compared with each other one",
         "leave out what is finer than the particle spacing",
         [](const Case& c) {
             return found_if(corners_of_outlines(c) > most_corners,
                             "the outlines have {} corners in all: expected at most {}",
                             corners_of_outlines(c), most_corners);
         }},
        {{"solid.name"},
         "an empty `name`",
         "messages name the solid",
         "give one",
         [](const Case&, const Solid& solid) { return found_if(solid.name.empty(), "name is empty"); }},
        {{"solid.name"},
         "the `name` of another solid",
         "each needs its own",
         "choose another one",
         [](const Case& c, const Solid& solid) {
             return found_if(repeats_a_name(c.solids, solid), "another solid has this name already");
         }},
    }};
}

CheckList solid_surface_refusals() {
    return {{
        {{"solid.surface", "turbulence.closure"},
         R"(`surface = "log-law"` with `turbulence.closure = "none"`)",
         "laminar flow has no log law",
         R"(choose a closure, or surface = "no-slip")",
         [](const Case& c, const Solid& solid) {
             return found_if(by_log_law(solid) && !has_closure(c),
                             "its surface has a log law, the flow no closure");
         }},
        {{"solid.surface", "bed.kind"},
         R"(`surface = "log-law"` of a section or a bed from data over a bed by a wall law)",
         "it lies over all of the bed, whose friction would count twice",
         R"(set [bed] kind = "slip")",
         [](const Case& c, const Solid& solid) {
             const bool covers = is_section(solid.shape) || solid.shape == SolidShape::bed;
             return found_if(by_log_law(solid) && covers && has_wall_law(c),
                             "its surface and the bed have a log law");
         }},
        {{"solid.manning", "solid.equivalent_roughness"},
         "`manning` of a solid beside its `equivalent_roughness`",
         "either tells how rough it is",
         "keep one of them",
         [](const Case&, const Solid& solid) {
             return found_if(by_log_law(solid) && solid.manning && solid.equivalent_roughness > 0.0,
                             "both are given");
         }},
        {{"solid.manning", "channel.depth"},
         "a `manning` of a solid that no roughness up to the depth of the case has",
         "",
         "give another n, or equivalent_roughness",
         [](const Case& c, const Solid& solid) {
             return found_if(
                 by_log_law(solid) && solid.manning && !roughness_of_surface_manning(c, *solid.manning),
                 "no k_s up to the depth of {} has n = {:g}", shown_length(c.total_depth()),
                 solid.manning.value_or(0.0));
         },
         true},
        {{"solid.equivalent_roughness", "fluid.kinematic_viscosity"},
         R"(a smooth `surface = "log-law"` without viscosity)",
         "the friction of a smooth wall is that of its viscous layer",
         "give the viscosity of the water, 1e-6, or an equivalent_roughness",
         [](const Case& c, const Solid& solid) {
             return found_if(by_log_law(solid) && surface_roughness(c, solid) <= 0.0 &&
                                 c.fluid.kinematic_viscosity <= 0.0,
                             "its surface is smooth, and the water has no viscosity");
         }},
        {{"solid.equivalent_roughness", "solid.manning", "numerics.spacing"},
         "`equivalent_roughness` of a solid above three spacings",
         "the friction acts in a layer of three spacings, in which the log law must have begun",
         "make the roughness smaller or the spacing larger, or give the roughness its shape",
         [](const Case& c, const Solid& solid) {
             const double roughness = surface_roughness(c, solid);
             return found_if(by_log_law(solid) && roughness > solid_friction_layer(c),
                             "{} is {}, three spacings are {}",
                             solid.manning ? "the k_s of its manning" : "equivalent_roughness",
                             shown_length(roughness), shown_length(solid_friction_layer(c)));
         }},
    }};
}

CheckList outline_refusals() {
    return {
        {
            {{"solid.name", "channel.top"},
             "a `[[solid]]` with `channel.top = \"periodic\"`",
             "a box without bed and surface has no walls",
             R"(set [channel] top = "free-surface" or "wall", or remove the solids)",
             [](const Case& c) { return !c.solids.empty() && c.channel.top == Top::periodic; }},
            {{"solid.x", "solid.z"},
             "`x` or `z` missing in two dimensions",
             "",
             R"(give the corners of its outline, for example x = ["100 mm", "140 mm", "120 mm"] and z = ["0 mm", "0 mm", "20 mm"])",
             [](const Case&, const Solid& solid) {
                 return found_if(solid.shape == SolidShape::free_form && (solid.x.empty() || solid.z.empty()),
                                 "x or z is missing");
             },
             true},
            outline_row(OutlineFault::uneven, {"solid.x", "solid.z"}, "not as many values of `x` as of `z`",
                        [](const Case&, const Solid& s) {
                            return outline_findings({s.x, s.z}, OutlineFault::uneven);
                        }),
            outline_row(OutlineFault::few, {"solid.x", "solid.z"}, "an outline of fewer than three corners",
                        [](const Case&, const Solid& s) {
                            return outline_findings({s.x, s.z}, OutlineFault::few);
                        }),
            outline_row(OutlineFault::crossing, {"solid.x", "solid.z"},
                        "an outline that crosses or touches itself",
                        [](const Case&, const Solid& s) {
                            return outline_findings({s.x, s.z}, OutlineFault::crossing);
                        }),
            {{"solid.x", "channel.length"},
             "an outline outside of the channel",
             "",
             "move it",
             [](const Case& c, const Solid& solid) {
                 const Extent x(solid.x);
                 return found_if(
                     x.high <= 0.0 || x.low >= c.channel.length || Extent(solid.z).high <= 0.0,
                     "lies outside of the channel: expected a part of x from 0 to {} and z above 0",
                     shown_length(c.channel.length));
             }},
            {{"solid.x", "channel.length"},
             "an outline longer than the channel less one kernel support of 2 h, between periodic ends",
             "its ends would meet",
             "make it shorter or the channel longer, or let it go through: beyond both ends by more than its layers of wall particles are thick, and at the same heights as in the channel",
             [](const Case& c, const Solid& solid) {
                 const double width = Extent(solid.x).high - Extent(solid.x).low;
                 return found_if(c.channel.ends == Ends::periodic &&
                                     width > c.channel.length - kernel_support(c) &&
                                     !passes_through(c, solid),
                                 "is {} long in a periodic channel of {}", shown_length(width),
                                 shown_length(c.channel.length));
             }},
            {{"solid.x"},
             "an outline around all of the channel, where the water has none of its own",
             "no water is left",
             "make it smaller",
             outline_that_fills_all},
            {{"solid.x", "numerics.spacing"},
             "an outline thinner than the `numerics.wall_layers` behind the middle of an edge",
             "water on one side would reach water on the other",
             "make it thicker or the spacing smaller",
             thin_outline},
        },
        [](const Case& c) {
            const bool drawn = std::all_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) {
                return solid.shape == SolidShape::free_form || !solid.x.empty();
            });
            return !in_space(c) && corners_of_outlines(c) <= most_corners && drawn;
        }};
}

}  // namespace riffle::inline case_file
