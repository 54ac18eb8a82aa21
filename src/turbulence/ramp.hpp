#pragma once

namespace riffle::inline turbulence {

/// Ramp mixing length (thesis 4.2; Nezu & Nakagawa 1993, Stansby 2003), m:
/// l_m = kappa z' for z'/h <= lambda/kappa, lambda h above, with z' = z - zero and h = depth - zero.
/// Zero at and below `zero`. All lengths in m over the bed level; `depth` is the total depth H.
template <class Real>
[[nodiscard]] constexpr Real ramp_mixing_length(Real z, Real zero, Real depth, Real kappa, Real lambda) {
    const Real slope = kappa * (z - zero);
    const Real plateau = lambda * (depth - zero);
    const Real length = slope < plateau ? slope : plateau;
    return length > Real(0) ? length : Real(0);
}

}  // namespace riffle::inline turbulence
