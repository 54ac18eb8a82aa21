#include <algorithm>

#include "case/cross_section.hpp"
#include "case/flow_kind.hpp"
#include "case/refusals.hpp"
#include "case/solid_shapes.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

/// What of a bed in space water can not enter and leave over.
Findings unlike_a_section(const Case& c, const Solid& solid) {
    if (!in_space(c) || !is_bed_shape(solid.shape)) return {};
    const auto beds = std::count_if(c.solids.begin(), c.solids.end(),
                                    [](const Solid& other) { return is_bed_shape(other.shape); });
    if (solid.shape == SolidShape::spheres || beds > 1) {
        return found_if(true, "\"{}\" is {}", solid.name,
                        beds > 1 ? "one of several beds" : "a layer of spheres");
    }
    // One that is drawn wrong is told of by itself.
    if (!is_section(solid.shape) || !section_fault(c, solid).empty()) return {};
    const CrossSection section = cross_section(c, solid);
    const double lowest = *std::min_element(section.levels.begin(), section.levels.end());
    return found_if(lowest > 1e-6 * c.total_depth(), "the lowest point of \"{}\" is {} over the bed level",
                    solid.name, shown_length(lowest));
}

}  // namespace

CheckList open_section_refusals() {
    return {
        {
            {{"channel.ends", "solid.shape"},
             "in three dimensions a layer of spheres that are solid, several beds, or a cross-section whose lowest point is above the bed level",
             "water enters and leaves over one bed, and depths count from the bed level",
             R"(give the bed as one `shape = "section"` (or "trapezoid", "compound", "pipe") with its lowest level at 0, or as one "bed" of heights, and what stands on it as [[solid]] away from the ends; or let the ends be periodic or walls)",
             [](const Case& c, const Solid& solid) { return unlike_a_section(c, solid); }},
            {{"outflow.kind", "solid.shape"},
             R"(`kind = "weir"` or `"free-fall"` of a channel with a cross-section of its own, or over measured heights)",
             "the crest of the weir and the edge of the bed are level all across the channel",
             R"(choose kind = "rating-curve" with the rating of the weir, "critical-depth", or another)",
             [](const Case& c) {
                 return uneven_bed_of(c) != nullptr &&
                        (c.outflow.kind == OutflowKind::weir || c.outflow.kind == OutflowKind::free_fall);
             }},
            {{"inflow.profile", "solid.shape"},
             R"(`profile = "column"`, `"file"` or `"results"` in a channel with a cross-section of its own, or over measured heights)",
             "they are over one depth all across the channel",
             R"(choose profile = "twin" (of a solid with surface = "log-law"), "log-law", "power-law" or "uniform")",
             [](const Case& c) {
                 const InflowProfile profile = c.inflow.profile;
                 return uneven_bed_of(c) != nullptr &&
                        (profile == InflowProfile::column || profile == InflowProfile::file ||
                         profile == InflowProfile::results);
             }},
            {{"inflow.profile", "outflow.kind", "start.kind", "solid.surface"},
             R"(the profile of the twin, the normal depth or `kind = "backwater"` over measured heights, or in a channel whose cross-section is not `surface = "log-law"`)",
             "nothing tells the friction of uniform flow there",
             R"(choose inflow.profile = "log-law" or "uniform", outflow.kind = "depth", "rating-curve" or "critical-depth" and another start; of a cross-section, or set surface = "log-law" and its equivalent_roughness)",
             [](const Case& c) {
                 return uneven_bed_of(c) != nullptr && canal_of(c) == nullptr &&
                        (c.inflow.profile == InflowProfile::twin ||
                         c.outflow.kind == OutflowKind::normal_depth || c.start.kind == StartKind::backwater);
             }},
            {{"channel.top", "solid.shape"},
             "`top = \"wall\"` over a cross-section or measured heights, with open ends",
             "what enters a duct fills a rectangle",
             "let the surface be free",
             [](const Case& c) { return is_duct(c) && uneven_bed_of(c) != nullptr; }},
        },
        [](const Case& c) { return c.channel.ends == Ends::open && in_space(c) && !c.solids.empty(); }};
}

}  // namespace riffle::inline case_file
