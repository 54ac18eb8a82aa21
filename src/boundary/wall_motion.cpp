#include "boundary/wall_motion.hpp"

#include <algorithm>
#include <cmath>

#include "case/solid_motion.hpp"

namespace riffle {

WallMotion::WallMotion(const Case& c)
    : solids_(c.solids),
      lid_velocity_(c.channel.lid_velocity),
      solids_move_(std::any_of(c.solids.begin(), c.solids.end(),
                               [](const Solid& s) { return s.motion != SolidMotion::fixed; })) {
    // Those of the case itself, which knows their surfaces.
    for (const Solid& solid : c.solids) {
        turning_.push_back(turns(c, solid) ? Turning{true, rotation_axis(solid), rotation_point(c, solid)}
                                           : Turning{});
    }
}

std::vector<BodyState> WallMotion::at(double time, std::span<const FreeBodyState> free) const {
    std::vector<BodyState> bodies(first_solid);
    bodies[lid_body].velocity[0] = lid_velocity_;
    std::size_t freed = 0;
    for (std::size_t k = 0; k < solids_.size(); ++k) {
        const Turning& turning = turning_[k];
        const SolidMotionState state = solid_motion(solids_[k], time);
        BodyState body{.displacement = state.displacement,
                       .velocity = state.velocity,
                       .acceleration = state.acceleration,
                       .turns = turning.turns,
                       .centre = turning.centre};
        const bool is_free = solids_[k].motion == SolidMotion::free;
        if (is_free && freed < free.size()) {
            free[freed].put_into(body);
        } else if (turning.turns) {
            body.rotation = rotation_about(turning.axis, state.angle);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                body.angular_velocity[axis] = state.angular_velocity * turning.axis[axis];
                body.angular_acceleration[axis] = state.angular_acceleration * turning.axis[axis];
            }
        }
        freed += is_free ? 1 : 0;
        bodies.push_back(body);
    }
    return bodies;
}

double largest_wall_speed(const Case& c) {
    double largest = std::abs(c.channel.lid_velocity);
    for (const Solid& solid : c.solids) {
        largest = std::max(largest, largest_speed(c, solid));
    }
    return largest;
}

}  // namespace riffle
