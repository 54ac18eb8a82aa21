#pragma once

#include <cmath>

#include "case/bed_traits.hpp"
#include "case/case.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::inline column {

/// The numbers of uniform flow at a mean velocity (m/s) in a channel so wide that its sides count for
/// nothing. The hydraulic radius is the depth over the datum, and between two walls at which the water rests
/// half of it; the energy falls by sin(theta) of the slope; long waves run by the part of gravity across the
/// bed.
struct WideChannel {
    double depth = 0.0;                ///< over the datum, m
    double hydraulic_radius = 0.0;     ///< m
    double streamwise_gravity = 0.0;   ///< g sin(theta), m/s2
    double normal_gravity = 0.0;       ///< g cos(theta), m/s2
    double energy_slope = 0.0;         ///< sin(theta)
    double kinematic_viscosity = 0.0;  ///< m2/s
    bool has_surface = true;           ///< else there is no Froude number, and no n and C of open channels

    [[nodiscard]] double friction_factor(double u) const {
        return riffle::friction_factor(streamwise_gravity, hydraulic_radius, u);
    }
    [[nodiscard]] double manning(double u) const {
        return manning_coefficient(energy_slope, hydraulic_radius, u);
    }
    [[nodiscard]] double chezy(double u) const {
        return chezy_coefficient(energy_slope, hydraulic_radius, u);
    }
    [[nodiscard]] double reynolds(double u) const { return reynolds_number(u, depth, kinematic_viscosity); }
    [[nodiscard]] double froude(double u) const { return froude_number(u, normal_gravity, depth); }
};

[[nodiscard]] inline WideChannel wide_channel(const Case& c) {
    const bool between_walls = c.channel.top == Top::wall && is_no_slip(c.bed);
    return {.depth = c.channel.depth,
            .hydraulic_radius = between_walls ? 0.5 * c.channel.depth : c.channel.depth,
            .streamwise_gravity = c.streamwise_gravity(),
            .normal_gravity = c.normal_gravity(),
            .energy_slope = c.streamwise_gravity() / c.fluid.gravity,
            .kinematic_viscosity = c.fluid.kinematic_viscosity,
            .has_surface = c.channel.top == Top::free_surface};
}

}  // namespace riffle::inline column
