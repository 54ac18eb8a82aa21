#pragma once

namespace riffle::inline turbulence {

// Lengths of closures for resolved eddies, so that one C_s means as much dissipation in isotropic turbulence
// with each. Their measures of the velocity gradient: sph/strain_measure.hpp.

/// Of the wall-adapting local eddy viscosity, m: C_w Delta with C_w^2 = 10.6 C_s^2. Nicoud & Ducros (1999).
template <class Real>
[[nodiscard]] constexpr Real wale_length(Real smagorinsky_constant, Real filter_width) {
    return Real(3.2557641192199412L) * smagorinsky_constant * filter_width;
}

/// Of Vreman's model, m: sqrt(c) Delta with c = 2.5 C_s^2. Vreman (2004).
template <class Real>
[[nodiscard]] constexpr Real vreman_length(Real smagorinsky_constant, Real filter_width) {
    return Real(1.5811388300841897L) * smagorinsky_constant * filter_width;
}

}  // namespace riffle::inline turbulence
