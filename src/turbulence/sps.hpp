#pragma once

namespace riffle::inline turbulence {

/// Length of the constant-C_s sub-particle-scale closure (thesis 4.1; Gotoh et al. 2001), m:
/// l = C_s Delta, so that nu_t = l^2 |S| with |S| = sqrt(2 S_ij S_ij). The same at every height.
template <class Real>
[[nodiscard]] constexpr Real sps_mixing_length(Real smagorinsky_constant, Real filter_width) {
    return smagorinsky_constant * filter_width;
}

/// Default filter width Delta = sqrt(dx^2 + dz^2)/2 = spacing/sqrt(2) (thesis 4.1; SPHysics), m.
template <class Real>
[[nodiscard]] constexpr Real sps_filter_width(Real spacing) {
    return spacing * Real(0.70710678118654752440L);
}

}  // namespace riffle::inline turbulence
