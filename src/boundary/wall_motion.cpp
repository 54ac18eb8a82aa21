#include "boundary/wall_motion.hpp"

#include <algorithm>
#include <cmath>

#include "case/solid_motion.hpp"

namespace riffle {

WallMotion::WallMotion(const Case& c)
    : solids_(c.solids),
      lid_velocity_(c.channel.lid_velocity),
      solids_move_(std::any_of(c.solids.begin(), c.solids.end(),
                               [](const Solid& s) { return s.motion != SolidMotion::fixed; })) {}

std::vector<BodyState> WallMotion::at(double time) const {
    std::vector<BodyState> bodies(first_solid);
    bodies[lid_body].velocity[0] = lid_velocity_;
    for (const Solid& solid : solids_) {
        const SolidMotionState state = solid_motion(solid, time);
        bodies.push_back({.displacement = state.displacement,
                          .velocity = state.velocity,
                          .acceleration = state.acceleration});
    }
    return bodies;
}

double largest_wall_speed(const Case& c) {
    double largest = std::abs(c.channel.lid_velocity);
    for (const Solid& solid : c.solids) {
        largest = std::max(largest, largest_speed(solid));
    }
    return largest;
}

}  // namespace riffle
