#pragma once

#include "turbulence/nikuradse.hpp"

namespace riffle::inline turbulence {

// The anisotropic mixing lengths of Czernuszenko & Rylov (2000; thesis 5.1-5.7). Over the height they follow
// Nezu & Rodi (nezu_rodi.hpp), l_x = l_z = l, l_y = q l, and beside the side walls both shrink by the factor
// below. The stresses are tau_ij = rho 1/2 (l_i^2 + l_j^2) |S| 2 S_ij.

/// Factor G of the mixing lengths at distance d from the nearer side wall: 1 in the middle zone, d >=
/// `edge_zone` (m, gamma L_y with L_y = H/2), and Ni(d/edge_zone)/Ni(1) beside the wall, Ni being Nikuradse's
/// profile; the division by Ni(1) is the only continuous join. Zero at and behind the wall.
template <class Real>
[[nodiscard]] constexpr Real edge_zone_factor(Real distance, Real edge_zone) {
    if (distance >= edge_zone) return Real(1);
    const Real at_one = Real(0.14);
    return nikuradse_mixing_length(distance / edge_zone, Real(0), Real(1)) / at_one;
}

/// Weight 1/2 (l_i^2 + l_j^2)/l_x^2 of the stress component (i, j); `across_i`, `across_j` say whether an
/// axis is the spanwise one, `spanwise_ratio` is q = l_y/l_x.
template <class Real>
[[nodiscard]] constexpr Real stress_weight(bool across_i, bool across_j, Real spanwise_ratio) {
    const Real square = spanwise_ratio * spanwise_ratio;
    return Real(0.5) * ((across_i ? square : Real(1)) + (across_j ? square : Real(1)));
}

/// The two-point viscosity of these stresses. A pair in the direction e acts on the velocity component k with
/// 2 nu_t K_k, K_k = level_k - slope e_y^2, so that the sum over the neighbours is nu_t (A_kx d2/dx2 + A_ky
/// d2/dy2 + A_kz d2/dz2) u_k with the weights A_kl of stress_weight(): from <e_m e_n e_y^2> = (delta_mn + 2
/// delta_my delta_ny)/15 over all directions, slope = 5/2 (A_kx - A_ky) and level_k = A_kx + 1/2 (A_kx -
/// A_ky).
template <class Real>
struct PairDirectionWeights {
    Real slope = Real(0);
    Real level = Real(1);         ///< of u and w
    Real level_across = Real(1);  ///< of v
};
template <class Real>
[[nodiscard]] constexpr PairDirectionWeights<Real> pair_direction_weights(Real spanwise_ratio) {
    const Real departure = Real(0.5) * (Real(1) - spanwise_ratio * spanwise_ratio);
    return {.slope = Real(2.5) * departure,
            .level = Real(1) + Real(0.5) * departure,
            .level_across = Real(1) - Real(0.5) * departure};
}

}  // namespace riffle::inline turbulence
