#pragma once

#include "roughness/sphere_bed.hpp"

namespace riffle::inline roughness {

/// Bed drag as printed in the thesis (4.3-4.4), 1/m: beta(z) = C_d l_r(z)/(dx * 1 m). It hides a width of
/// 1 m and scales as 1/dx, so that the spacing is part of the physics; kept to reproduce the thesis.
template <class Real>
[[nodiscard]] Real thesis_drag_coefficient(Real z, Real drag_coefficient, Real diameter,
                                           Real roughness_height, Real spacing) {
    constexpr Real hidden_width = Real(1);  // m
    return drag_coefficient * sphere_half_chord(z, diameter, roughness_height) / (spacing * hidden_width);
}

}  // namespace riffle::inline roughness
