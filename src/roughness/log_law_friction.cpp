#include "roughness/log_law_friction.hpp"

#include <algorithm>
#include <cmath>

#include "case/bed_friction.hpp"
#include "case/surface_roughness.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline roughness {

LogLawFriction::LogLawFriction(const Case& c, double layer, double roughness)
    : kappa_(c.turbulence.kappa),
      layer_(layer),
      viscosity_(c.fluid.kinematic_viscosity),
      rough_zero_height_(zero_height_of_roughness(roughness, kappa_)) {}

LogLawFriction side_wall_friction(const Case& c) {
    const auto& own = c.side_walls.equivalent_roughness;
    return {c, c.side_layer(), own ? *own : equivalent_roughness(c)};
}

LogLawFriction solid_friction(const Case& c, const Solid& solid) {
    return {c, solid_friction_layer(c), surface_roughness(c, solid)};
}

LogLawFriction solid_friction(const Case& c, const SurfacePatch& patch) {
    return {c, solid_friction_layer(c), surface_roughness(c, patch)};
}

double LogLawFriction::coefficient(double square) const {
    const double speed = std::sqrt(std::max(0.0, square));
    const auto ratio = [&](double friction_velocity) {
        double zero = rough_zero_height_;
        if (viscosity_ > 0.0) {
            // Water that hardly moves has a viscous layer thicker than the layer of the drag.
            zero += friction_velocity > 0.0
                        ? zero_height_of_smooth_wall(viscosity_ / friction_velocity, kappa_)
                        : layer_;
        }
        return log_law_mean(layer_, std::min(zero, layer_), kappa_);
    };
    // The ratio knows of the friction velocity by a logarithm: each round makes the error ten times smaller.
    constexpr int rounds = 30;
    constexpr double of_speed = 0.05;
    double friction_velocity = of_speed * speed;
    for (int i = 0; viscosity_ > 0.0 && i < rounds; ++i) {
        const double next = speed / ratio(friction_velocity);
        const bool settled = std::abs(next - friction_velocity) <= 1e-14 * next;
        friction_velocity = next;
        if (settled) break;
    }
    const double of_wall = ratio(friction_velocity);
    return 1.0 / (of_wall * of_wall * layer_);
}

double LogLawFriction::slope(double square) const {
    if (viscosity_ <= 0.0 || !(square > 0.0)) return 0.0;
    constexpr double step = 1e-4;
    return (coefficient((1.0 + step) * square) - coefficient((1.0 - step) * square)) / (2.0 * step * square);
}

}  // namespace riffle::inline roughness
