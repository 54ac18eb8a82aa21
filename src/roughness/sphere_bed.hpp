#pragma once

#include <cmath>

namespace riffle::inline roughness {

/// Half chord of a bed sphere at height z (thesis 4.3), m: l_r = sqrt(R^2 - (z + R - d_h)^2) for
/// 0 <= z <= d_h, zero elsewhere. R = D/2; the sphere's top stands at the roughness height d_h.
template <class Real>
[[nodiscard]] Real sphere_half_chord(Real z, Real diameter, Real roughness_height) {
    if (z < Real(0) || z > roughness_height) return Real(0);
    const Real radius = diameter / Real(2);
    const Real offset = z + radius - roughness_height;
    const Real square = (radius - offset) * (radius + offset);
    return square > Real(0) ? std::sqrt(square) : Real(0);
}

/// Spheres per plan area of one hexagonally packed layer, 2/(sqrt(3) D^2), 1/m2.
template <class Real>
[[nodiscard]] constexpr Real hexagonal_spheres_per_area(Real diameter) {
    return Real(1.15470053837925152902L) / (diameter * diameter);
}

/// Spheres per plan area of one square-packed layer, 1/D^2, 1/m2.
template <class Real>
[[nodiscard]] constexpr Real square_spheres_per_area(Real diameter) {
    return Real(1) / (diameter * diameter);
}

}  // namespace riffle::inline roughness
