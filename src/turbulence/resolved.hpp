#pragma once

#include <cmath>

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

/// Of Smagorinsky's model, m: C_s Delta, and no more than kappa times the distance from a rough wall (m),
/// where the eddies are as small as that: 1/l^2 = 1/(C_s Delta)^2 + 1/(kappa d)^2. Mason & Thomson (1992)
/// with the power 2.
template <class Real>
[[nodiscard]] Real smagorinsky_length(Real smagorinsky_constant, Real filter_width, Real kappa,
                                      Real distance) {
    if (!(distance > Real(0))) return Real(0);
    const Real of_filter = smagorinsky_constant * filter_width;
    const Real of_wall = kappa * distance;
    return of_filter * of_wall / std::hypot(of_filter, of_wall);
}

}  // namespace riffle::inline turbulence
