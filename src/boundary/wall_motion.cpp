#include "boundary/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace riffle {

namespace {

double angular_frequency(const Solid& solid) { return 2.0 * std::numbers::pi * solid.frequency; }

BodyState state_of(const Solid& solid, double time) {
    BodyState state;
    const bool stopped = solid.stop && time >= *solid.stop;
    const double moving = (stopped ? *solid.stop : time) - solid.start;
    if (moving <= 0.0) {
        return state;
    }
    if (solid.motion == SolidMotion::constant) {
        state.velocity = {solid.velocity_x, solid.velocity_z};
        state.displacement = {moving * solid.velocity_x, moving * solid.velocity_z};
    } else if (solid.motion == SolidMotion::oscillating) {
        const double omega = angular_frequency(solid);
        const double sine = std::sin(omega * moving);
        const double cosine = std::cos(omega * moving);
        const Vec<2> amplitude{solid.amplitude_x, solid.amplitude_z};
        for (std::size_t k = 0; k < 2; ++k) {
            state.displacement[k] = amplitude[k] * sine;
            state.velocity[k] = amplitude[k] * omega * cosine;
            state.acceleration[k] = -amplitude[k] * omega * omega * sine;
        }
    }
    if (stopped) {
        state.velocity = {};
        state.acceleration = {};
    }
    return state;
}

}  // namespace

WallMotion::WallMotion(const Case& c)
    : solids_(c.solids),
      lid_velocity_(c.channel.lid_velocity),
      solids_move_(std::any_of(c.solids.begin(), c.solids.end(),
                               [](const Solid& s) { return s.motion != SolidMotion::fixed; })) {}

std::vector<BodyState> WallMotion::at(double time) const {
    std::vector<BodyState> bodies(first_solid);
    bodies[lid_body].velocity[0] = lid_velocity_;
    for (const Solid& solid : solids_) {
        bodies.push_back(state_of(solid, time));
    }
    return bodies;
}

double largest_wall_speed(const Case& c) {
    double largest = std::abs(c.channel.lid_velocity);
    for (const Solid& solid : c.solids) {
        if (solid.motion == SolidMotion::constant) {
            largest = std::max(largest, std::hypot(solid.velocity_x, solid.velocity_z));
        } else if (solid.motion == SolidMotion::oscillating) {
            largest = std::max(largest,
                               angular_frequency(solid) * std::hypot(solid.amplitude_x, solid.amplitude_z));
        }
    }
    return largest;
}

}  // namespace riffle
