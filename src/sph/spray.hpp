#pragma once

#include "sph/correction.hpp"

namespace riffle::inline sph {

/// Where spray ends, by the smallest eigenvalue of M: from here on a particle is one of the water. It is 1
/// inside and 1/2 at a flat surface; the tip of a front that runs along a bed has 0.2 to 0.3 and must stay
/// water, or it runs ahead; drops of a few particles have less.
inline constexpr double spray_end = 0.17;

/// How far a particle of this regularity is water: 0 for spray, 1 for water, smooth between. Spray bears no
/// suction, and what pressure it has fades at the rate c0/h: air surrounds it. Held together by suction, a
/// drop that spins would turn faster and faster.
template <class T>
RIFFLE_INLINE T share_of_water(const T& regularity) {
    using R = scalar_of<T>;
    return smoothstep<T>(R(0.12), R(spray_end), regularity);
}

}  // namespace riffle::inline sph
