#pragma once

#include <cmath>

#include "sph/pair_terms.hpp"

namespace riffle::inline sph {

// The kernel gradient correction of a particle: small matrices on scalars or lanes. Symmetric matrices are
// stored as their upper triangle, row by row: (xx, xz, zz) in 2D, (xx, xy, xz, yy, yz, zz) in 3D.

template <class T, int D>
using Symmetric = std::array<T, static_cast<std::size_t>(D*(D + 1) / 2)>;

/// Position of element (k, l) in the upper triangle.
template <int D>
constexpr std::size_t symmetric_index(int k, int l) {
    const int row = k < l ? k : l;
    const int column = k < l ? l : k;
    return static_cast<std::size_t>(row * D - row * (row - 1) / 2 + column - row);
}

/// Smoothstep: 0 below `low`, 1 above `high`.
template <class T>
RIFFLE_INLINE T smoothstep(scalar_of<T> low, scalar_of<T> high, const T& x) {
    using R = scalar_of<T>;
    const T t = R(1) - positive_part<T>(R(1) - positive_part<T>((x - low) * (R(1) / (high - low))));
    return t * t * (R(3) - R(2) * t);
}

/// Determinant of a symmetric matrix.
template <class T, int D>
RIFFLE_INLINE T determinant(const Symmetric<T, D>& m) {
    if constexpr (D == 2) {
        return m[0] * m[2] - m[1] * m[1];
    } else {
        return m[0] * (m[3] * m[5] - m[4] * m[4]) - m[1] * (m[1] * m[5] - m[4] * m[2]) +
               m[2] * (m[1] * m[4] - m[3] * m[2]);
    }
}

/// The cofactors of a symmetric matrix, its inverse times its determinant.
template <class T, int D>
RIFFLE_INLINE Symmetric<T, D> cofactors(const Symmetric<T, D>& m) {
    if constexpr (D == 2) {
        return {m[2], -m[1], m[0]};
    } else {
        return {m[3] * m[5] - m[4] * m[4], m[2] * m[4] - m[1] * m[5], m[1] * m[4] - m[2] * m[3],
                m[0] * m[5] - m[2] * m[2], m[1] * m[2] - m[0] * m[4], m[0] * m[3] - m[1] * m[1]};
    }
}

/// Inverse of a symmetric matrix, the determinant kept away from zero (the callers blend the result out
/// there).
template <class T, int D>
RIFFLE_INLINE Symmetric<T, D> inverse(const Symmetric<T, D>& m) {
    using R = scalar_of<T>;
    using std::max;
    using std::experimental::max;
    const T scale = R(1) / max(determinant<T, D>(m), T(R(0.02)));
    const Symmetric<T, D> c = cofactors<T, D>(m);
    if constexpr (D == 2) {
        return {c[0] * scale, c[1] * scale, c[2] * scale};
    } else {
        return {c[0] * scale, c[1] * scale, c[2] * scale, c[3] * scale, c[4] * scale, c[5] * scale};
    }
}

/// Smallest eigenvalue of a symmetric matrix. In 3D it is q - p (1 + w): q = tr/3, and the deviator M - q I,
/// scaled by p = |M - q I|/sqrt(6), has the characteristic cubic t^3 - 3 t - 2 r = 0 with |r| <= 1, whose
/// smallest root is t = -1 - w, w^2 (3 + w) = 2 (1 - r). The fixed point of w contracts by w/(6 + 2 w) <=
/// 1/8. Exact where eigenvalues meet, within 1e-4 p elsewhere.
template <class T, int D>
RIFFLE_INLINE T smallest_eigenvalue(const Symmetric<T, D>& m) {
    using R = scalar_of<T>;
    using std::sqrt;
    using std::experimental::sqrt;
    if constexpr (D == 2) {
        const T half_difference = R(0.5) * (m[0] - m[2]);
        return R(0.5) * (m[0] + m[2]) - sqrt(half_difference * half_difference + m[1] * m[1]);
    } else {
        const T mean = (m[0] + m[3] + m[5]) * R(1.0 / 3.0);
        Symmetric<T, D> deviator = m;
        for (const std::size_t k : {0U, 3U, 5U}) {
            deviator[k] -= mean;
        }
        const T p_squared = (deviator[0] * deviator[0] + deviator[3] * deviator[3] +
                             deviator[5] * deviator[5] + R(2) * (m[1] * m[1] + m[2] * m[2] + m[4] * m[4])) *
                            R(1.0 / 6.0);
        const T p = sqrt(p_squared);
        const T r = determinant<T, D>(deviator) / (R(2) * p_squared * p + R(1e-30));
        const T rest = positive_part<T>(R(2) * (R(1) - r));
        T w = sqrt(rest * R(1.0 / 3.5));
        for (int step = 0; step < 3; ++step) w = sqrt(rest / (R(3) + w));
        return mean - p * (R(1) + w);
    }
}

/// The matrix B of the pressure form. Fluid pairs are corrected, wall pairs are not: with uniform pressure
/// the virial B M_fluid + M_wall must be the identity, so B = (I - M_wall) M_fluid^-1. Near a free surface B
/// fades into the identity, by the smallest eigenvalue of M_fluid + M_wall. Row-major D x D.
template <class T, int D>
RIFFLE_INLINE Components<T, D * D> pressure_correction(const Symmetric<T, D>& m_fluid,
                                                       const Symmetric<T, D>& m_wall, const T& blend) {
    using R = scalar_of<T>;
    const Symmetric<T, D> inv = inverse<T, D>(m_fluid);
    Components<T, D * D> b{};
    for (int k = 0; k < D; ++k) {
        for (int l = 0; l < D; ++l) {
            T sum = inv[symmetric_index<D>(k, l)];
            for (int m = 0; m < D; ++m) {
                sum -= m_wall[symmetric_index<D>(k, m)] * inv[symmetric_index<D>(m, l)];
            }
            const R identity = k == l ? R(1) : R(0);
            b[static_cast<std::size_t>(k) * D + static_cast<std::size_t>(l)] =
                identity + blend * (sum - identity);
        }
    }
    return b;
}

}  // namespace riffle::inline sph
