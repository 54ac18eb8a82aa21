#pragma once

#include <cmath>

namespace riffle::inline analysis {

/// Small waves on water of uniform depth that flows at a uniform velocity along x (Lamb, Hydrodynamics,
/// art. 266 f.): omega = k U +- sqrt((g k + sigma k^3 / rho) tanh(k H)). SI; k in rad/m, omega in rad/s.
/// The particles have no surface tension: take 0 for a simulation, 0.072 N/m for clean water.
struct GravityCapillaryWaves {
    double depth = 0.0;     ///< H, m
    double velocity = 0.0;  ///< U, m/s: that of the surface for short waves, the depth mean for long ones
    double gravity = 9.81;  ///< component normal to the bed, m/s2
    double surface_tension = 0.0;  ///< sigma, N/m
    double density = 1000.0;       ///< rho, kg/m3

    /// sqrt((g |k| + sigma |k|^3 / rho) tanh(|k| H)): the frequency seen by one who moves with the water.
    [[nodiscard]] double intrinsic_frequency(double k) const {
        const double size = std::abs(k);
        return std::sqrt((gravity * size + surface_tension * size * size * size / density) *
                         std::tanh(size * depth));
    }
    /// Waves that travel downstream through the water, k > 0.
    [[nodiscard]] double downstream_frequency(double k) const {
        return k * velocity + intrinsic_frequency(k);
    }
    /// Waves that travel upstream through the water, k > 0; negative where the current does not hold them
    /// back, so that they travel upstream over the bed, too.
    [[nodiscard]] double upstream_frequency(double k) const { return k * velocity - intrinsic_frequency(k); }
    /// The advection line: patterns that the water carries.
    [[nodiscard]] double advection_frequency(double k) const { return k * velocity; }
};

}  // namespace riffle::inline analysis
