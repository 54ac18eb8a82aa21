#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

Outline water_of(const Case& c) { return {c.start.water_x, c.start.water_z}; }

Findings water_findings(const Case& c, OutlineFault fault) {
    return outline_findings(water_of(c), fault, "water_x, water_z: ");
}

/// Height of the end walls, m.
double end_wall_height(const Case& c) { return c.channel.wall_height.value_or(wave_height(c)); }

Findings corners_in_solids(const Case& c) {
    const Outline water = water_of(c);
    Findings found;
    for (const Solid& solid : c.solids) {
        const Outline body{solid.x, solid.z};
        if (!is_simple(body)) {
            continue;  // said of the solid
        }
        for (std::size_t i = 0; i < water.size(); ++i) {
            if (contains(body, water.x[i], water.z[i]) &&
                distance_from_outline(body, water.x[i], water.z[i]) > 0.5 * c.numerics.spacing) {
                found.push_back(
                    {.detail = fmt::format(
                         "water_x, water_z: the corner {} of the water lies inside of the solid \"{}\"",
                         corner_text(water, i), solid.name)});
            }
        }
    }
    return found;
}

}  // namespace

CheckList water_refusals() {
    const std::vector<std::string> keys = {"start.water_x", "start.water_z"};
    return {
        {
            outline_row(OutlineFault::uneven, keys, "not as many values of `water_x` as of `water_z`",
                        [](const Case& c) { return water_findings(c, OutlineFault::uneven); }),
            outline_row(OutlineFault::few, keys, "`water_x`, `water_z` of fewer than three corners",
                        [](const Case& c) { return water_findings(c, OutlineFault::few); }),
            outline_row(OutlineFault::crossing, keys, "`water_x`, `water_z` that cross or touch themselves",
                        [](const Case& c) { return water_findings(c, OutlineFault::crossing); }),
            {{"start.water_x", "start.water_z", "channel.top"},
             "`water_x`, `water_z` without a free surface",
             "the water fills all up to the top",
             "remove them, or set [channel] top = \"free-surface\"",
             [](const Case& c) {
                 return found_if(!has_free_surface(c), "water_x, water_z: there is no free surface");
             }},
            {{"start.water_x", "start.water_z", "channel.length"},
             "`water_x`, `water_z` outside of the channel",
             "",
             "move it, or make the channel longer",
             [](const Case& c) {
                 const Extent x(c.start.water_x);
                 return found_if(
                     x.low < 0.0 || x.high > c.channel.length || Extent(c.start.water_z).low < 0.0,
                     "water_x, water_z: the water lies outside of the channel: expected x from 0 to its length {} and z from 0",
                     shown_length(c.channel.length));
             }},
            {{"start.water_z", "channel.wall_height"},
             "`water_z` above the end walls",
             "the water would run over them",
             "give [channel] wall_height",
             [](const Case& c) {
                 const double high = Extent(c.start.water_z).high;
                 return found_if(c.channel.ends == Ends::walls && high > end_wall_height(c) * (1 + 1e-9),
                                 "water_z: the water stands {} high, and the end walls {}",
                                 shown_length(high), shown_length(end_wall_height(c)));
             }},
            {{"start.water_x", "start.water_z", "numerics.spacing"},
             "water narrower or lower than one kernel support of 2 h",
             "the kernel must find its place in the water",
             "make the spacing smaller",
             [](const Case& c) {
                 const double width = Extent(c.start.water_x).size();
                 const double height = Extent(c.start.water_z).size();
                 return found_if(height < kernel_support(c) || width < kernel_support(c),
                                 "water_x, water_z: the water is {} by {}, less than one kernel support ({})",
                                 shown_length(width), shown_length(height), shown_length(kernel_support(c)));
             }},
            {{"start.water_x", "start.water_z"},
             "a corner of the water inside of a solid",
             "",
             "move one of them",
             corners_in_solids},
        },
        [](const Case& c) {
            return !(c.start.water_x.empty() && c.start.water_z.empty()) &&
                   corners_of_outlines(c) <= most_corners;
        }};
}

}  // namespace riffle::inline case_file
