#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "case/body_state.hpp"
#include "case/end_buffers.hpp"
#include "case/outline_check.hpp"
#include "case/porous_zone.hpp"
#include "case/refusals.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_motion.hpp"
#include "case/solid_overlap.hpp"
#include "case/solid_shapes.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

bool moves_on(const Solid& solid) { return solid.motion == SolidMotion::constant; }
bool swings(const Solid& solid) { return solid.motion == SolidMotion::oscillating; }

std::array<double, 3> velocity_of(const Solid& solid) {
    return {solid.velocity_x, solid.velocity_y, solid.velocity_z};
}

std::array<double, 3> amplitude_of(const Solid& solid) {
    return {solid.amplitude_x, solid.amplitude_y, solid.amplitude_z};
}

bool is_zero(const std::array<double, 3>& v) { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; }

/// How long a solid moves in the run, s.
double time_of_motion(const Case& c, const Solid& solid) {
    return std::max(0.0, std::min(solid.stop.value_or(c.run.time), c.run.time) - solid.start);
}

struct Swing {
    double low = 0.0;
    double high = 0.0;
};

/// What a solid that turns or follows a table takes up along an axis, by its corners at many times: steps of
/// a degree, up to two turns of one that goes on for ever.
Swing along_its_way(const Case& c, const Solid& solid, std::size_t axis) {
    const std::vector<std::array<double, 3>> corners = corners_of(c, solid);
    const SolidTurning turn = solid_turning(c, solid);
    const double last = solid.is_free() ? 0.0 : c.run.time;
    constexpr int steps = 720;
    const double rate = std::abs(solid.angular_velocity);
    const double turning = moves_on(solid) && is_zero(velocity_of(solid)) && rate > 0.0
                               ? solid.start + 4.0 * std::numbers::pi / rate
                               : last;
    Swing range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int step = 0; step <= steps; ++step) {
        const BodyState body = body_state(solid_motion(solid, std::min(last, turning) * step / steps), turn);
        for (const auto& corner : corners) {
            const double x = body.placed(corner)[axis];
            range = {std::min(range.low, x), std::max(range.high, x)};
        }
    }
    return range;
}

/// What a solid takes up along axis x, y or z, with its way.
Swing in_motion(const Case& c, const Solid& solid, std::size_t axis) {
    if (turns(c, solid) || solid.motion == SolidMotion::table) return along_its_way(c, solid, axis);
    const double way = moves_on(solid) ? time_of_motion(c, solid) * velocity_of(solid)[axis] : 0.0;
    const double swing = swings(solid) ? std::abs(amplitude_of(solid)[axis]) : 0.0;
    const Extent start = *extent_of(c, solid, axis);
    return {start.low + std::min(way, -swing), start.high + std::max(way, swing)};
}

/// So far a solid may stand in the bed or a wall that it touches, m: by rounding, and by the corners of a
/// round shape.
double slack_of(const Case& c, const Solid& solid) {
    return 1e-9 * c.numerics.spacing + corners_outside(c, solid);
}

/// Whether it goes through one of two walls.
bool leaves(const Case& c, const Solid& solid, std::size_t axis, double extent) {
    const Swing range = in_motion(c, solid, axis);
    const double slack = slack_of(c, solid);
    return range.low < -slack || range.high > extent + slack;
}

Findings motion_through_walls(const Case& c, const Solid& solid) {
    if (solid.rests()) {
        return {};
    }
    const bool ends = c.channel.ends == Ends::walls;
    const bool sides = in_space(c) && c.channel.sides != Sides::periodic;
    const double width = c.channel.simulated_width();
    if (solid.is_free()) {
        return {};  // looked at below
    }
    // Where it sinks to is looked at below.
    const bool sinks = moves_on(solid) && !turns(c, solid);
    const double lowest = sinks ? extent_of(c, solid, 2)->low : in_motion(c, solid, 2).low;
    const bool outside = lowest < -slack_of(c, solid) || (ends && leaves(c, solid, 0, c.channel.length)) ||
                         (sides && leaves(c, solid, 1, width));
    return found_if(outside, "moves through the bed{}: expected room for it, x from 0 to {}{} and z from 0",
                    in_space(c) ? ", an end wall or a side wall" : " or an end wall",
                    shown_length(c.channel.length),
                    in_space(c) ? ", y from 0 to " + shown_length(width) : std::string());
}

/// Whether a solid that starts away from open ends comes to where the water is watched beside one.
Findings motion_into_ends(const Case& c, const Solid& solid) {
    if (c.channel.ends != Ends::open || solid.rests() || solid.is_free()) {
        return {};
    }
    const double clear = watched_stretch(c);
    const double length = c.channel.length;
    const Swing way = in_motion(c, solid, 0);
    const Extent start = *extent_of(c, solid, 0);
    const bool starts_clear = start.low >= clear && start.high <= length - clear;
    return found_if(starts_clear && (way.low < clear || way.high > length - clear),
                    "its way reaches from x = {} to {}, and the water is watched up to x = {} and from {}",
                    shown_length(way.low), shown_length(way.high), shown_length(clear),
                    shown_length(length - clear));
}

/// A zone, of places on a lattice in what a solid takes up with its way, that holds one of them.
Findings motion_through_a_zone(const Case& c, const Solid& solid) {
    if (solid.rests() || solid.is_free() || c.porous.empty()) {
        return {};
    }
    constexpr int most = 40;
    const Swing x = in_motion(c, solid, 0);
    const Swing z = in_motion(c, solid, 2);
    const Swing y = in_space(c) ? in_motion(c, solid, 1) : Swing{0.0, 0.0};
    const auto at = [](const Swing& range, int i, int of) {
        return range.low + (i + 0.5) / of * (range.high - range.low);
    };
    for (const Porous& porous : c.porous) {
        const PorousZone zone(c, porous);
        for (int i = 0; i < most * most; ++i) {
            for (int j = 0; j < (in_space(c) ? most : 1); ++j) {
                if (zone.holds(at(x, i % most, most), in_space(c) ? at(y, j, most) : 0.0,
                               at(z, i / most, most))) {
                    return found_if(true, "moves through the porous zone \"{}\"", porous.name);
                }
            }
        }
    }
    return {};
}

/// Solids that move through each other press the water between them out of the world.
Findings overlap(const Case& c) {
    const auto overlap = first_overlap(c);
    if (!overlap) {
        return {};
    }
    const std::string& name = c.solids[overlap->second].name;
    const std::string& other = c.solids[overlap->first].name;
    const auto& [x, y, z] = overlap->place;
    const std::string where = in_space(c)
                                  ? fmt::format("at x = {:.4g} m, y = {:.4g} m, z = {:.4g} m", x, y, z)
                                  : fmt::format("at x = {:.4g} m, z = {:.4g} m", x, z);
    return {overlap->time == 0.0
                ? CaseFinding{.detail = fmt::format("{}: stands in the solid \"{}\" at the start, {}", name,
                                                    other, where),
                              .cure = "move one of them",
                              .item = overlap->second}
                : CaseFinding{.detail = fmt::format("{}: meets the solid \"{}\" at t = {:.4g} s, {}", name,
                                                    other, overlap->time, where),
                              .item = overlap->second}};
}

}  // namespace

CheckList motion_refusals() {
    return {
        {
            {{"solid.velocity_y", "solid.amplitude_y", "solid.shifts_y", "solid.spring_y",
              "solid.rotation_axis", "solid.moves_y", "solid.turns_x", "solid.turns_z", "channel.dimensions"},
             "`velocity_y`, `amplitude_y`, `shifts_y`, `spring_y`, `rotation_axis`, or `false` for `moves_y`, `turns_x` or `turns_z`, in two dimensions",
             "nothing moves across a plane",
             "remove the key, or set [channel] dimensions = 3",
             [](const Case& c, const Solid& solid) {
                 const bool across = solid.velocity_y != 0.0 || solid.amplitude_y != 0.0 ||
                                     solid.spring_y != 0.0 || !solid.shifts_y.empty() ||
                                     !solid.rotation_axis.empty();
                 if (!in_space(c) && across) return found_if(true, "moves across the channel");
                 const bool held = !solid.moves_y || !solid.turns_x || !solid.turns_z;
                 return found_if(!in_space(c) && held,
                                 "is held across the channel or about an axis along its plane");
             }},
            {{"solid.motion"},
             "`motion = \"constant\"` without a velocity",
             "",
             "give velocity_x, velocity_z, angular_velocity or, in three dimensions, velocity_y; or motion = \"fixed\"",
             [](const Case&, const Solid& solid) {
                 return found_if(
                     moves_on(solid) && is_zero(velocity_of(solid)) && solid.angular_velocity == 0.0,
                     "moves at no velocity");
             }},
            {{"solid.motion"},
             "`motion = \"oscillating\"` without an amplitude or a frequency",
             "",
             "give amplitude_x, amplitude_z, amplitude_angle or, in three dimensions, amplitude_y and frequency; or motion = \"fixed\"",
             [](const Case&, const Solid& solid) {
                 const bool still = is_zero(amplitude_of(solid)) && solid.amplitude_angle == 0.0;
                 return found_if(swings(solid) && (still || solid.frequency <= 0.0), "swings by nothing");
             }},
            {{"solid.start"},
             "`start` at the end of the run or later",
             "it would stand still",
             "make it smaller",
             [](const Case& c, const Solid& solid) {
                 return found_if(!solid.rests() && solid.start >= c.run.time,
                                 "starts to move at {:.6g} s, not before the end of the run at {:.6g} s",
                                 solid.start, c.run.time);
             }},
            {{"solid.stop"},
             "`stop` not after `start`",
             "it would stand still",
             "make it larger, or motion = \"fixed\"",
             [](const Case&, const Solid& solid) {
                 const double stop = solid.stop.value_or(solid.start);
                 return found_if(!solid.rests() && solid.stop && stop <= solid.start,
                                 "stops at {:.6g} s, not after its start at {:.6g} s", stop, solid.start);
             }},
            {{"solid.motion", "channel.length"},
             "a motion through the bed, an end wall or a side wall",
             "",
             "give it another way, or let it stop before (stop)",
             motion_through_walls},
            {{"solid.velocity_z"},
             "a `velocity_z` that brings the solid to the bed before the end of the run",
             "",
             "make it slower, or let it stop before (stop)",
             [](const Case& c, const Solid& solid) {
                 return found_if(moves_on(solid) && !turns(c, solid) && solid.velocity_z < 0.0 &&
                                     in_motion(c, solid, 2).low < -slack_of(c, solid),
                                 "reaches the bed before the end of the run");
             }},
            {{"solid.motion", "channel.ends"},
             "a motion of a solid into the water that enters or leaves",
             "beside either end the water is watched over two kernel supports or a quarter of the depth, whichever is longer",
             "let it stop before (stop), give it another way, or make the channel longer",
             motion_into_ends},
            {{"solid.motion", "porous.name"},
             "a motion through a porous zone",
             "the water would be pressed out of the grains as out of nothing",
             "let it stop before (stop), give it another way, or move the zone",
             motion_through_a_zone},
            {{"solid.motion"},
             "a motion through another solid",
             "it would move through it",
             "let it stop before (stop), or give it another way",
             overlap},
        },
        have_shapes};
}

}  // namespace riffle::inline case_file
