// What solids that turn, follow a table or are free are refused for.

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_motion.hpp"
#include "case/solid_shapes.hpp"
#include "case/solid_volume.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

/// The least restitution of soft contacts with critical damping, exp(-2) (boundary/body_contact.hpp).
constexpr double least_restitution = 0.1354;

Findings wrong_point(const Case& c, const char* key, const std::vector<double>& values) {
    return found_if(!values.empty() && values.size() != static_cast<std::size_t>(c.channel.dimensions),
                    "{} holds {} {}; expected {}", key, values.size(),
                    values.size() == 1 ? "value" : "values",
                    in_space(c) ? "three: x, y and z" : "two: x and z");
}

Findings wrong_table(const Case&, const Solid& solid) {
    if (solid.motion != SolidMotion::table) {
        return {};
    }
    const std::vector<double>& times = solid.times;
    if (times.size() < 2) {
        return found_if(true, "times holds {} values: expected two or more", times.size());
    }
    if (times.front() != 0.0 ||
        std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end()) {
        return found_if(true, "times do not grow from 0");
    }
    const std::array columns{std::pair("shifts_x", &solid.shifts_x), std::pair("shifts_y", &solid.shifts_y),
                             std::pair("shifts_z", &solid.shifts_z), std::pair("angles", &solid.angles)};
    bool moves = false;
    for (const auto& [name, values] : columns) {
        if (values->empty()) continue;
        if (values->size() != times.size()) {
            return found_if(true, "{} holds {} values, and times {}", name, values->size(), times.size());
        }
        if (values->front() != 0.0) {
            return found_if(true, "{} begins with {:.6g}, not with 0", name, values->front());
        }
        moves = moves || std::any_of(values->begin(), values->end(), [](double v) { return v != 0.0; });
    }
    return found_if(!moves, "the table moves it by nothing");
}

Findings wrong_axis(const Case& c, const Solid& solid) {
    const std::vector<double>& axis = solid.rotation_axis;
    const bool zero = std::all_of(axis.begin(), axis.end(), [](double v) { return v == 0.0; });
    return found_if(in_space(c) && !axis.empty() && (axis.size() != 3 || zero),
                    "rotation_axis is no direction of three numbers");
}

/// Where the channel repeats itself a body that turns must not meet its image.
Findings meets_itself(const Case& c, const Solid& solid) {
    if (!turns(c, solid)) {
        return {};
    }
    const double across = 2.0 * reach_from(c, solid, rotation_point(c, solid));
    const auto meets = [&](bool periodic, double period) {
        return periodic && across > period - kernel_support(c);
    };
    return found_if(meets(c.channel.ends == Ends::periodic, c.channel.length) ||
                        meets(in_space(c) && c.channel.sides == Sides::periodic, c.channel.simulated_width()),
                    "takes up {} as it turns", shown_length(across));
}

/// How far a free body stands behind a wall at the start, m; up to a hair it touches it.
Findings starts_in_a_wall(const Case& c, const Solid& solid) {
    if (!solid.is_free()) {
        return {};
    }
    const double slack = 1e-3 * c.numerics.spacing + corners_outside(c, solid);
    const auto behind = [&](std::size_t axis, double extent) {
        const auto range = extent_of(c, solid, axis);
        return range && (range->low < -slack || range->high > extent + slack);
    };
    const auto z = extent_of(c, solid, 2);
    return found_if(
        (z && z->low < -slack) || (c.channel.top == Top::wall && z && z->high > c.total_depth() + slack) ||
            (c.channel.ends == Ends::walls && behind(0, c.channel.length)) ||
            (in_space(c) && c.channel.sides != Sides::periodic && behind(1, c.channel.simulated_width())),
        "starts in the bed or a wall");
}

/// What is given of a motion that a free body cannot make.
Findings along_what_is_held(const Case& c, const Solid& solid) {
    if (!solid.is_free()) {
        return {};
    }
    struct Along {
        const char* moves;
        bool free;
        double velocity;
        double spring;
    };
    for (const Along& along : {Along{"x", solid.moves_x, solid.velocity_x, solid.spring_x},
                               Along{"y", solid.moves_y, solid.velocity_y, solid.spring_y},
                               Along{"z", solid.moves_z, solid.velocity_z, solid.spring_z}}) {
        if (!along.free && (along.velocity != 0.0 || along.spring != 0.0)) {
            return found_if(true, "moves_{} is false, and velocity_{} or spring_{} is given", along.moves,
                            along.moves, along.moves);
        }
    }
    const bool still = !turns(c, solid);
    const auto axis = rotation_axis(solid);
    const bool held = still || (axis[0] != 0.0 && !solid.turns_x) || (axis[1] != 0.0 && !solid.turns_y) ||
                      (axis[2] != 0.0 && !solid.turns_z);
    return found_if((held && solid.angular_velocity != 0.0) || (still && !solid.inertia.empty()),
                    "is not free to turn, and angular_velocity or inertia is given");
}

Findings centre_outside(const Case& c, const Solid& solid) {
    const std::vector<double>& centre = solid.centre_of_mass;
    const std::size_t dimensions = in_space(c) ? 3 : 2;
    if (!solid.is_free() || centre.size() != dimensions) {
        return {};
    }
    for (std::size_t k = 0; k < dimensions; ++k) {
        const auto range = extent_of(c, solid, dimensions == 2 && k == 1 ? 2 : k);
        if (range && (centre[k] < range->low || centre[k] > range->high)) {
            return found_if(true, "is {} along {}, and the body reaches from {} to {}",
                            shown_length(centre[k]),
                            k == 0                      ? "x"
                            : dimensions == 2 || k == 2 ? "z"
                                                        : "y",
                            shown_length(range->low), shown_length(range->high));
        }
    }
    return {};
}

Findings impossible_inertia(const Case& c, const Solid& solid) {
    const std::vector<double>& inertia = solid.inertia;
    if (!solid.is_free() || inertia.size() != (in_space(c) ? 3U : 1U)) {
        return {};
    }
    const double mass =
        solid.mass ? *solid.mass : solid.density.value_or(0.0) * solid_volume(c, solid).volume;
    const double size = reach_from(c, solid, rotation_point(c, solid));
    const double least = 1e-3 * mass * size * size;
    for (const double moment : inertia) {
        if (moment < least) {
            return found_if(true, "holds {:.4g} {}: expected {:.4g} or more of its mass {:.4g} {}", moment,
                            in_space(c) ? "kg m2" : "kg m", least, mass, in_space(c) ? "kg" : "kg/m");
        }
    }
    if (inertia.size() == 3) {
        const double sum = inertia[0] + inertia[1] + inertia[2];
        const double largest = *std::max_element(inertia.begin(), inertia.end());
        return found_if(largest > (sum - largest) * (1 + 1e-9),
                        "holds {:.4g} kg m2, more than both others together", largest);
    }
    return {};
}

}  // namespace

CheckList turning_refusals() {
    return {{
        {{"solid.times", "solid.shifts_x", "solid.shifts_y", "solid.shifts_z", "solid.angles"},
         "a table of a motion whose `times` do not grow from 0, or whose columns are not as long or do not begin "
         "with 0",
         "it starts where it stands",
         "give as many values of shifts_x, shifts_z or angles as of times, the first of each 0",
         wrong_table},
        {{"solid.rotation_axis"},
         "a `rotation_axis` that is no direction",
         "",
         "give three numbers, not all of them 0, for example rotation_axis = [0, 0, 1]",
         wrong_axis},
        {{"solid.rotation_about"},
         "`rotation_about` without as many values as the case has dimensions",
         "",
         "give x, y and z of the point, in two dimensions x and z alone, or remove the key for the centroid",
         [](const Case& c, const Solid& solid) {
             return wrong_point(c, "rotation_about", solid.rotation_about);
         }},
        {{"solid.centre_of_mass"},
         "`centre_of_mass` without as many values as the case has dimensions",
         "",
         "give x, y and z of the point, in two dimensions x and z alone, or remove the key for the centroid",
         [](const Case& c, const Solid& solid) {
             return wrong_point(c, "centre_of_mass", solid.centre_of_mass);
         }},
        {{"solid.inertia"},
         "`inertia` without three values in three dimensions, one in two",
         "",
         "give the moments of inertia about x, y and z, in two dimensions the one about y alone, or remove the key",
         [](const Case& c, const Solid& solid) {
             const std::size_t expected = in_space(c) ? 3 : 1;
             return found_if(!solid.inertia.empty() && solid.inertia.size() != expected,
                             "inertia holds {} values", solid.inertia.size());
         }},
        {{"solid.density", "solid.mass", "solid.motion"},
         "a free body with neither a `density` nor a `mass`, or with both",
         "one of them says what it weighs",
         "give one, for example density = 700",
         [](const Case&, const Solid& solid) {
             return found_if(solid.is_free() && solid.density.has_value() == solid.mass.has_value(), "has {}",
                             solid.density ? "a density and a mass" : "no density and no mass");
         }},
        {{"solid.restitution"},
         "a `restitution` below 0.1354",
         "exp(-2) is what critical damping leaves",
         "make it larger",
         [](const Case&, const Solid& solid) {
             return found_if(solid.is_free() && solid.restitution < least_restitution,
                             "restitution is {:.4g}", solid.restitution);
         }},
        {{"solid.moves_x", "solid.moves_y", "solid.moves_z", "solid.turns_x", "solid.turns_y",
          "solid.turns_z"},
         "a free body without any degree of freedom",
         "it would stand still",
         "set one of them to true, or motion = \"fixed\"",
         [](const Case& c, const Solid& solid) {
             const bool moves = solid.moves_x || solid.moves_z || (in_space(c) && solid.moves_y);
             return found_if(solid.is_free() && !moves && !turns(c, solid), "is not free to move");
         }},
    }};
}

CheckList free_body_refusals() {
    return {
        {
            {{"solid.moves_x", "solid.moves_y", "solid.moves_z", "solid.turns_x", "solid.turns_y",
              "solid.turns_z"},
             "a velocity, a spring, an angular velocity or moments of inertia of a free body for a motion that it is not free to make",
             "they would do nothing",
             "remove the key, or free the motion",
             along_what_is_held},
            {{"solid.centre_of_mass"},
             "a `centre_of_mass` outside of the box around its body",
             "no distribution of its mass puts it there",
             "correct it: it is a place in the channel, not one from the body's middle",
             centre_outside},
            {{"solid.inertia"},
             "moments of inertia far below those of the mass, or such that no body has",
             "the largest is at most the sum of the others, and a body with none of its mass away from its centre has no size",
             "correct them, or remove the key for those of the shape",
             impossible_inertia},
            {{"solid.motion", "porous.name"},
             "a free body beside a porous zone",
             "grains do not hold bodies back: it would sink through them",
             R"(hold it (motion = "fixed"), or give the grains as a [[solid]])",
             [](const Case& c) {
                 return !c.porous.empty() &&
                        std::any_of(c.solids.begin(), c.solids.end(), std::mem_fn(&Solid::is_free));
             }},
            {{"solid.motion", "numerics.stepping"},
             "a free body with a method of two stages or of rates of the step before",
             "bodies take one step with the water, by forces of one evaluation",
             R"(set [numerics] stepping = "leapfrog" or "semi-implicit-euler")",
             [](const Case& c) {
                 const bool fused = c.numerics.stepping == Stepping::leapfrog ||
                                    c.numerics.stepping == Stepping::semi_implicit_euler;
                 return !fused && std::any_of(c.solids.begin(), c.solids.end(), std::mem_fn(&Solid::is_free));
             }},
            {{"solid.motion", "channel.length", "channel.width"},
             "a solid that turns and takes up more than a periodic channel less one kernel support of 2 h",
             "it would meet its own image",
             "make it smaller or the channel longer",
             meets_itself},
            {{"solid.motion", "channel.depth"},
             "a free body that starts in the bed or a wall",
             "contact would throw it out",
             "move it",
             starts_in_a_wall},
        },
        have_shapes};
}

}  // namespace riffle::inline case_file
