#pragma once

#include <cmath>
#include <experimental/simd>

#include "sph/correction.hpp"
#include "sph/pair_terms.hpp"

namespace riffle::inline sph {

/// What a closure makes of the velocity gradient, 1/s: the eddy viscosity is its length squared times this.
enum class StrainMeasure {
    strain_rate,          ///< |S|: of mixing lengths and of Smagorinsky's model
    rotation,             ///< |W|, the magnitude of the vorticity: Baldwin & Lomax (1978)
    strain_and_rotation,  ///< sqrt(|S| |W|): Kato & Launder (1993)
    wale,                 ///< Nicoud & Ducros (1999)
    vreman                ///< Vreman (2004)
};

/// Strain rate |S| = sqrt(2 S_ij S_ij) from the velocity gradient du_k/dx_l at k D + l.
template <class T, int D>
RIFFLE_INLINE T strain_rate(const Components<T, D * D>& g) {
    using std::sqrt;
    using std::experimental::sqrt;
    using R = scalar_of<T>;
    T sum(0);
    for (std::size_t k = 0; k < D; ++k) {
        sum += R(2) * g[k * D + k] * g[k * D + k];
        for (std::size_t l = k + 1; l < D; ++l) {
            const T shear = g[k * D + l] + g[l * D + k];
            sum += shear * shear;
        }
    }
    return sqrt(sum);
}

/// Rate of rotation |W| = sqrt(2 W_ij W_ij), the magnitude of the vorticity: |S| in plane shear, and zero
/// where water is drawn out or pressed together without turning.
template <class T, int D>
RIFFLE_INLINE T rotation_rate(const Components<T, D * D>& g) {
    using std::sqrt;
    using std::experimental::sqrt;
    T sum(0);
    for (std::size_t k = 0; k < D; ++k) {
        for (std::size_t l = k + 1; l < D; ++l) {
            const T turn = g[k * D + l] - g[l * D + k];
            sum += turn * turn;
        }
    }
    return sqrt(sum);
}

/// The operator of the wall-adapting local eddy viscosity: (S^d:S^d)^(3/2) / [(S:S)^(5/2) + (S^d:S^d)^(5/4)],
/// S^d the traceless symmetric part of the square of the velocity gradient. Zero in plane shear. Nicoud &
/// Ducros (1999), (13).
template <class T>
RIFFLE_INLINE T wale_rate(const Components<T, 9>& g) {
    using std::sqrt;
    using std::experimental::sqrt;
    using R = scalar_of<T>;
    Components<T, 9> squared{};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
            squared[3 * k + l] = g[3 * k] * g[l] + g[3 * k + 1] * g[3 + l] + g[3 * k + 2] * g[6 + l];
        }
    }
    const T third = R(1.0 / 3.0) * (squared[0] + squared[4] + squared[8]);
    T deviator(0);
    T strain(0);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
            T d = R(0.5) * (squared[3 * k + l] + squared[3 * l + k]);
            if (k == l) d -= third;
            const T s = R(0.5) * (g[3 * k + l] + g[3 * l + k]);
            deviator += d * d;
            strain += s * s;
        }
    }
    const T root = sqrt(deviator);
    // Far below any gradient of a flow: water at rest has none.
    const T least(R(1e-30));
    return deviator * root / (strain * strain * sqrt(strain) + deviator * sqrt(root) + least);
}

/// Vreman's operator sqrt(B_beta / (g:g)), beta = g g^T and B_beta the sum of its principal minors. Zero in
/// plane shear and in all flows that are locally laminar in his sense. Vreman (2004), (5) to (8), with one
/// filter width.
template <class T>
RIFFLE_INLINE T vreman_rate(const Components<T, 9>& g) {
    using std::max;
    using std::sqrt;
    using std::experimental::max;
    using std::experimental::sqrt;
    using R = scalar_of<T>;
    const auto beta = [&](std::size_t k, std::size_t l) {
        return T(g[3 * k] * g[3 * l] + g[3 * k + 1] * g[3 * l + 1] + g[3 * k + 2] * g[3 * l + 2]);
    };
    const T xx = beta(0, 0);
    const T yy = beta(1, 1);
    const T zz = beta(2, 2);
    const T xy = beta(0, 1);
    const T xz = beta(0, 2);
    const T yz = beta(1, 2);
    const T minors = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
    // Rounding may leave what is zero a little below.
    return sqrt(max(minors, T(0)) / (xx + yy + zz + T(R(1e-30))));
}

}  // namespace riffle::inline sph
