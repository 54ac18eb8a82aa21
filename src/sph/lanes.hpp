#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <experimental/simd>
#include <type_traits>

#include "particles/clusters.hpp"

/// Functions of the inner loops: always inlined, so that each instruction set keeps its own code.
#define RIFFLE_INLINE [[gnu::always_inline]] inline

namespace riffle::inline sph {

/// The values of the particles of a cluster, one lane each: one register where the instruction set has one of
/// that size.
template <class Real>
using Lanes = std::experimental::simd<
    Real, std::experimental::simd_abi::deduce_t<Real, static_cast<std::size_t>(cluster_size)>>;

namespace detail {
template <class T>
struct ScalarOf {
    using type = T;
};
template <class R, class Abi>
struct ScalarOf<std::experimental::simd<R, Abi>> {
    using type = R;
};
}  // namespace detail

/// Scalar type of a scalar or of a vector of lanes.
template <class T>
using scalar_of = typename detail::ScalarOf<T>::type;

/// max(x, 0) for a scalar or lanes.
template <class T>
RIFFLE_INLINE T positive_part(T x) {
    using std::max;
    using std::experimental::max;
    return max(x, T(0));
}

template <class Real>
RIFFLE_INLINE Lanes<Real> load_lanes(const Real* p) {
    return Lanes<Real>(p, std::experimental::element_aligned);
}

template <class Real>
RIFFLE_INLINE void store_lanes(const Lanes<Real>& v, Real* p) {
    v.copy_to(p, std::experimental::element_aligned);
}

}  // namespace riffle::inline sph
