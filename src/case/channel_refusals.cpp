#include "case/bed_traits.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

bool has_periodic_top(const Case& c) { return c.channel.top == Top::periodic; }
bool has_lid(const Case& c) { return c.channel.lid_velocity != 0.0; }

/// Longest channel in which positions, 32-bit fractions of the length, are exact to 1e-5 spacings: that costs
/// 1e-4 g in the accelerations. m.
double longest_channel(const Case& c) { return 1e-5 * c.numerics.spacing * 4294967296.0; }

double least_depth(const Case& c) { return has_periodic_top(c) ? least_period(c) : kernel_support(c); }

}  // namespace

CheckList channel_refusals() {
    return {{
        {{"channel.length", "numerics.spacing"},
         "`length` too short for periodic ends",
         "two kernel supports of 2 h with their skin, so that no particle meets its own image",
         "make the reach longer or the spacing smaller",
         [](const Case& c) {
             return found_if(c.channel.ends == Ends::periodic && c.channel.length < least_period(c),
                             "length is {}: periodic ends need at least {}", shown_length(c.channel.length),
                             shown_length(least_period(c)));
         }},
        {{"channel.length", "numerics.spacing"},
         "`length` above 42 949 spacings",
         "",
         "make the channel shorter or the spacing larger",
         [](const Case& c) {
             return found_if(
                 c.channel.length > longest_channel(c),
                 "length is {}: at a spacing of {} the positions, 32-bit integers, resolve channels of up to {}",
                 shown_length(c.channel.length), shown_length(c.numerics.spacing),
                 shown_length(longest_channel(c)));
         }},
        {{"channel.depth", "numerics.spacing"},
         "a total depth below one kernel support of 2 h, or, where the top is periodic, below two with their skin",
         "the kernel must find its place in the water",
         "make the spacing smaller",
         [](const Case& c) {
             return found_if(c.total_depth() < least_depth(c),
                             "the total depth is {}, and at least {} is needed",
                             shown_length(c.total_depth()), shown_length(least_depth(c)));
         }},
        {{"fluid.gravity"},
         "`gravity` 0 with a free surface",
         "a free surface needs gravity",
         "give 9.81, or choose another [channel] top",
         [](const Case& c) { return has_free_surface(c) && c.fluid.gravity <= 0.0; }},
        {{"channel.top", "bed.kind"},
         R"(a `top` other than `"free-surface"` with `bed.kind = "spheres"`)",
         "such a top goes with a smooth bed",
         R"(set [bed] kind = "slip" or, below a wall, "no-slip")",
         [](const Case& c) { return !has_free_surface(c) && over_spheres(c); }},
        {{"channel.ends", "channel.top"},
         R"(`ends = "walls"` with `top = "periodic"`)",
         "a periodic top needs ends = \"periodic\" as well",
         "set it",
         [](const Case& c) { return has_periodic_top(c) && c.channel.ends != Ends::periodic; }},
        {{"bed.kind", "channel.top"},
         R"(`kind = "no-slip"` with `channel.top = "periodic"`)",
         "where the top joins the bottom there is no bed",
         "set kind = \"slip\"",
         [](const Case& c) { return has_periodic_top(c) && is_no_slip(c.bed); }},
        {{"fluid.gravity", "channel.top"},
         "`gravity` other than 0 with `channel.top = \"periodic\"`",
         "gravity must be 0 where no bed carries the water",
         "set it to 0",
         [](const Case& c) { return has_periodic_top(c) && c.fluid.gravity != 0.0; }},
        {{"channel.wall_height", "channel.top"},
         "`wall_height` without a free surface",
         "the end walls reach up to the top",
         "remove wall_height",
         [](const Case& c) { return c.channel.wall_height && !has_free_surface(c); }},
        {{"channel.wall_height", "channel.depth"},
         "`wall_height` below the total depth, where the water has no outline of its own",
         "the water would run over the end walls",
         "make them higher",
         [](const Case& c) {
             const double height = c.channel.wall_height.value_or(c.total_depth());
             return found_if(has_free_surface(c) && height < c.total_depth() && c.start.water_x.empty(),
                             "wall_height is {}, lower than the water, {}", shown_length(height),
                             shown_length(c.total_depth()));
         }},
        {{"channel.lid_velocity", "bed.kind"},
         "`lid_velocity` without `bed.kind = \"no-slip\"`",
         "a lid without friction does not move the water, and the bed's kind is that of all walls",
         "set [bed] kind = \"no-slip\"",
         [](const Case& c) { return has_lid(c) && !is_no_slip(c.bed); }},
        {{"channel.lid_velocity", "numerics.wall"},
         "`lid_velocity` without `numerics.wall = \"dummy\"`",
         "the particles of the other walls stand still",
         "choose wall = \"dummy\"",
         [](const Case& c) { return has_lid(c) && c.numerics.wall != WallKind::dummy; }},
    }};
}

}  // namespace riffle::inline case_file
