#include "case/solid_motion.hpp"

#include <cmath>
#include <numbers>

namespace riffle {

namespace {

double angular_frequency(const Solid& solid) { return 2.0 * std::numbers::pi * solid.frequency; }

}  // namespace

SolidMotionState solid_motion(const Solid& solid, double time) {
    SolidMotionState state;
    const bool stopped = solid.stop && time >= *solid.stop;
    const double moving = (stopped ? *solid.stop : time) - solid.start;
    if (moving <= 0.0) {
        return state;
    }
    if (solid.motion == SolidMotion::constant) {
        state.velocity = {solid.velocity_x, solid.velocity_y, solid.velocity_z};
        for (std::size_t k = 0; k < 3; ++k) {
            state.displacement[k] = moving * state.velocity[k];
        }
    } else if (solid.motion == SolidMotion::oscillating) {
        const double omega = angular_frequency(solid);
        const double sine = std::sin(omega * moving);
        const double cosine = std::cos(omega * moving);
        const std::array<double, 3> amplitude{solid.amplitude_x, solid.amplitude_y, solid.amplitude_z};
        for (std::size_t k = 0; k < 3; ++k) {
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

double largest_speed(const Solid& solid) {
    switch (solid.motion) {
        case SolidMotion::fixed:
            return 0.0;
        case SolidMotion::constant:
            return std::hypot(solid.velocity_x, solid.velocity_y, solid.velocity_z);
        case SolidMotion::oscillating:
            return angular_frequency(solid) *
                   std::hypot(solid.amplitude_x, solid.amplitude_y, solid.amplitude_z);
    }
    return 0.0;
}

}  // namespace riffle
