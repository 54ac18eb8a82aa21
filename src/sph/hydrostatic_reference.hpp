#pragma once

#include <cmath>

#include "sph/lanes.hpp"

namespace riffle::inline sph {

/// The hydrostatic part of the pressure that acts as a body force instead of through the pairs
/// (docs/theory.md, section 5, "The reference pressure"): a function of the height alone,
/// nothing above `level`, below it a parabola over `fade`, and from there on the weight of the water below
/// the middle of `fade`.
struct HydrostaticReference {
    double level = 0.0;    ///< z where it begins, m
    double fade = 0.0;     ///< height over which its gradient grows, m
    double gravity = 0.0;  ///< of the water below, m/s2; 0: no reference pressure

    [[nodiscard]] bool acts() const { return gravity > 0.0; }

    /// Over rho0 at height z, m2/s2. T: a scalar or lanes.
    template <class T>
    [[nodiscard]] RIFFLE_INLINE T value(const T& z) const {
        const T below = larger(level - z);
        const T begun = below - larger(T(below - fade));
        return gravity * (begun * begun / (2.0 * fade) + (below - begun));
    }
    /// How it grows downwards: the acceleration that it gives upwards to water of density rho0, m/s2.
    template <class T>
    [[nodiscard]] RIFFLE_INLINE T slope(const T& z) const {
        const T below = larger(level - z);
        return gravity / fade * (below - larger(T(below - fade)));
    }

  private:
    template <class T>
    [[nodiscard]] RIFFLE_INLINE static T larger(const T& x) {
        using std::abs;
        return T(0.5 * (x + abs(x)));
    }
};

}  // namespace riffle::inline sph
