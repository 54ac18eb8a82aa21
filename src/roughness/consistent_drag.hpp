#pragma once

#include "roughness/sphere_bed.hpp"

namespace riffle::inline roughness {

/// Consistent bed drag (thesis 2.16, 4.3), 1/m: beta(z) = 1/2 C_d a(z), frontal area per volume
/// a(z) = 2 n_s l_r(z), n_s spheres per plan area, l_r the half chord (thesis 4.3). From the drag force
/// (thesis 2.16) on n_s spheres per plan area, spread over the volume of each height; free of the spacing.
template <class Real>
[[nodiscard]] Real consistent_drag_coefficient(Real z, Real drag_coefficient, Real diameter,
                                               Real roughness_height, Real spheres_per_area) {
    const Real frontal_area = Real(2) * spheres_per_area * sphere_half_chord(z, diameter, roughness_height);
    return Real(0.5) * drag_coefficient * frontal_area;
}

}  // namespace riffle::inline roughness
