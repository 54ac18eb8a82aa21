#pragma once

#include "sph/equation_of_state.hpp"

namespace riffle::inline sph {

/// Elastic energy of the compression per mass, the integral of p/rho^2 from rho0 to rho0 (1 + s), m2/s2. The
/// series in s, to its fourth power, avoids the cancellation of the closed forms: s is a hundredth and less.
[[nodiscard]] inline double elastic_energy(const StateEquation& state, double s) {
    const double c2 = state.sound_speed * state.sound_speed;
    // p/rho0 = c0^2 (s + second s^2 + third s^3 + ...).
    const double n = state.kind == EquationOfState::linear ? 1.0 : StateEquation::tait_exponent;
    const double second = (n - 1.0) / 2.0;
    const double third = (n - 1.0) * (n - 2.0) / 6.0;
    return c2 * s * s * (0.5 + s * ((second - 2.0) / 3.0 + s * (third - 2.0 * second + 3.0) / 4.0));
}

}  // namespace riffle::inline sph
