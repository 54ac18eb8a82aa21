#pragma once

#include <cmath>

#include "case/options.hpp"

namespace riffle::inline sph {

/// Equation of state in terms of the density deviation s = rho/rho0 - 1. Pressures are divided by rho0
/// (m2/s2).
struct StateEquation {
    EquationOfState kind = EquationOfState::linear;
    double sound_speed = 0.0;  ///< c0, m/s

    static constexpr double tait_exponent = 7.0;

    /// p/rho0. Linear: c0^2 s (Morris; paper eq. 10). Tait: c0^2/7 [(1 + s)^7 - 1] (thesis 2.45).
    [[nodiscard]] double pressure(double s) const {
        const double c2 = sound_speed * sound_speed;
        if (kind == EquationOfState::linear) return c2 * s;
        // expm1 and log1p keep the small deviation free of cancellation.
        return c2 / tait_exponent * std::expm1(tait_exponent * std::log1p(s));
    }

    /// The inverse: s at the pressure p/rho0.
    [[nodiscard]] double deviation(double pressure_over_density) const {
        const double c2 = sound_speed * sound_speed;
        if (kind == EquationOfState::linear) return pressure_over_density / c2;
        return std::expm1(std::log1p(tait_exponent * pressure_over_density / c2) / tait_exponent);
    }
};

}  // namespace riffle::inline sph
