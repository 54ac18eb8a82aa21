#include "boundary/wall_motion.hpp"

#include <algorithm>
#include <cmath>

#include "case/solid_motion.hpp"

namespace riffle::inline boundary {

WallMotion::WallMotion(const Case& c)
    : solids_(c.solids),
      lid_velocity_(c.channel.lid_velocity),
      solids_move_(std::any_of(c.solids.begin(), c.solids.end(), [](const Solid& s) { return !s.rests(); })) {
    // Those of the case itself, which knows their surfaces.
    for (const Solid& solid : c.solids) turning_.push_back(solid_turning(c, solid));
}

std::vector<BodyState> WallMotion::at(double time, std::span<const FreeBodyState> free) const {
    std::vector<BodyState> bodies(first_solid);
    bodies[lid_body].velocity[0] = lid_velocity_;
    std::size_t freed = 0;
    for (std::size_t k = 0; k < solids_.size(); ++k) {
        BodyState body = body_state(solid_motion(solids_[k], time), turning_[k]);
        const bool is_free = solids_[k].is_free();
        if (is_free && freed < free.size()) free[freed].put_into(body);
        freed += is_free ? 1 : 0;
        bodies.push_back(body);
    }
    return bodies;
}

double largest_wall_speed(const Case& c) {
    double largest = std::abs(c.channel.lid_velocity);
    for (const Solid& solid : c.solids) largest = std::max(largest, largest_speed(c, solid));
    return largest;
}

}  // namespace riffle::inline boundary
