#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace riffle::inline roughness {

// Drag of the bed's spheres on the water inside them, in three dimensions: acceleration -beta u|u| of each
// horizontal component (thesis 5.8-5.10), beta = phi times one of these, 1/m.

/// Consistent form: the drag 1/2 C_d (pi R^2) u|u| of a sphere spread over its volume, 3 C_d/(4 D).
template <class Real>
[[nodiscard]] constexpr Real volume_drag_coefficient(Real drag_coefficient, Real diameter) {
    return Real(0.75) * drag_coefficient / diameter;
}

/// Slice form: the drag 1/2 C_d 2 l of each slice of a sphere, l its chord radius at that height, spread over
/// the slice: C_d/(pi l). With a sharp surface its plan mean is the consistent form in two dimensions. l is
/// at least half the ramp, over which the slice's edge is smeared.
template <class Real>
[[nodiscard]] Real slice_drag_coefficient(Real z, Real drag_coefficient, Real diameter, Real centre_height,
                                          Real ramp) {
    const Real radius = diameter / Real(2);
    const Real offset = z - centre_height;
    const Real square = (radius - offset) * (radius + offset);
    const Real chord = std::max(square > Real(0) ? std::sqrt(square) : Real(0), ramp / Real(2));
    return drag_coefficient / (std::numbers::pi_v<Real> * chord);
}

/// As printed in the thesis (5.9-5.10), C_d/(2 dx): each particle carries the whole frontal area, so that the
/// drag scales as 1/dx.
template <class Real>
[[nodiscard]] constexpr Real printed_sphere_drag_coefficient(Real drag_coefficient, Real spacing) {
    return drag_coefficient / (Real(2) * spacing);
}

}  // namespace riffle::inline roughness
