#pragma once

namespace riffle::inline turbulence {

/// Nikuradse's mixing length (thesis 2.20), m:
/// l_m/h = 0.14 - 0.08 (1 - xi)^2 - 0.06 (1 - xi)^4, xi = (z - zero)/h, h = depth - zero.
/// Zero at and below `zero`; above the surface the value of the surface, 0.14 h.
/// Its slope at the bed is 0.40 whatever kappa is.
template <class Real>
[[nodiscard]] constexpr Real nikuradse_mixing_length(Real z, Real zero, Real depth) {
    const Real h = depth - zero;
    const Real xi = (z - zero) / h;
    if (!(xi > Real(0))) return Real(0);
    const Real rest = xi < Real(1) ? (Real(1) - xi) * (Real(1) - xi) : Real(0);
    return h * (Real(0.14) - Real(0.08) * rest - Real(0.06) * rest * rest);
}

}  // namespace riffle::inline turbulence
