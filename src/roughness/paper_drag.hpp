#pragma once

namespace riffle::inline roughness {

/// Bed drag of the paper (Kazemi et al. 2016, eqs. 4-5), 1/m: beta = C_d/(2 d_s) for 0 <= z <= R_d, zero
/// elsewhere. d_s is the sphere diameter, R_d the roughness height.
template <class Real>
[[nodiscard]] constexpr Real paper_drag_coefficient(Real z, Real drag_coefficient, Real diameter,
                                                    Real roughness_height) {
    return z < Real(0) || z > roughness_height ? Real(0) : drag_coefficient / (Real(2) * diameter);
}

}  // namespace riffle::inline roughness
