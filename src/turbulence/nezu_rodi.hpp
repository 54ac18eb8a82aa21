#pragma once

#include <cmath>
#include <numbers>

namespace riffle::inline turbulence {

/// Mixing length of the log-wake law (thesis 2.21; Nezu & Rodi 1986), m:
/// l_m/h = kappa sqrt(1 - xi) / (1/xi + pi Pi sin(pi xi)), xi = (z - zero)/h, h = depth - zero,
/// Pi Coles' wake strength. Zero at and below `zero`, and at and above the surface.
template <class Real>
[[nodiscard]] Real nezu_rodi_mixing_length(Real z, Real zero, Real depth, Real kappa, Real wake_strength) {
    const Real h = depth - zero;
    const Real xi = (z - zero) / h;
    if (!(xi > Real(0)) || xi >= Real(1)) return Real(0);
    constexpr Real pi = std::numbers::pi_v<Real>;
    // Multiplied through by xi, so that xi -> 0 divides by 1 and not by infinity.
    return h * kappa * xi * std::sqrt(Real(1) - xi) / (Real(1) + pi * wake_strength * xi * std::sin(pi * xi));
}

}  // namespace riffle::inline turbulence
