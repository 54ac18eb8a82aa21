#pragma once

#include <array>

#include "sph/lanes.hpp"

namespace riffle::inline sph {

// The terms of the equations of motion for one pair of particles i, j: small pure functions on scalars or
// lanes. r = x_i - x_j, u = u_i - u_j; F is the kernel gradient factor, grad_i W_ij = F r (F < 0), V_j the
// volume of j. Each returns what j adds to the sum of i, up to a constant of the whole sum: the loops measure
// r in smoothing lengths and leave the kernel's constant to the end (pair_loops_impl.hpp).

template <class T, int D>
using Components = std::array<T, static_cast<std::size_t>(D)>;

template <class T, int D>
RIFFLE_INLINE T dot(const Components<T, D>& a, const Components<T, D>& b) {
    T sum = a[0] * b[0];
    for (std::size_t k = 1; k < D; ++k) sum += a[k] * b[k];
    return sum;
}

/// Continuity: V_j u.grad W. Relative rate of density, (D rho/Dt)/rho (model.md, paper eq. 8).
template <class T, int D>
RIFFLE_INLINE T continuity(const T& volume_gradient, const Components<T, D>& u, const Components<T, D>& r) {
    return volume_gradient * dot<T, D>(u, r);
}

/// Density diffusion of Fourtakas et al. (2019): V_j (s_i - s_j + k r_z) F, k r_z the hydrostatic part of the
/// difference, so that it vanishes at rest. The sum is multiplied by 2 delta h c0.
template <class T, class R>
RIFFLE_INLINE T density_diffusion(const T& volume_gradient, const T& s_difference, const T& r_vertical,
                                  R hydrostatic_gradient) {
    return volume_gradient * (s_difference + hydrostatic_gradient * r_vertical);
}

/// Pressure and stress in conservative form: -w_j (Q_i + Q_j) grad W, Q = (p B - tau)/rho0 (row-major D x D).
/// With B = M^-1 this is the kernel-gradient-corrected form of docs/theory.md; with Q = p/rho^2 I, thesis
/// (2.42).
template <class T, int D>
RIFFLE_INLINE Components<T, D> tensor_force(const T& weight_gradient, const Components<T, D * D>& q_sum,
                                            const Components<T, D>& r) {
    Components<T, D> a{};
    for (std::size_t k = 0; k < D; ++k) {
        T sum = q_sum[k * D] * r[0];
        for (std::size_t l = 1; l < D; ++l) sum += q_sum[k * D + l] * r[l];
        a[k] = -weight_gradient * sum;
    }
    return a;
}

/// Pressure alone, -w_j (p_i + p_j) grad W with a scalar p: the same with Q = p I, without the matrix.
template <class T, int D>
RIFFLE_INLINE Components<T, D> tensor_force(const T& weight_gradient, const Components<T, 1>& p_sum,
                                            const Components<T, D>& r) {
    const T factor = weight_gradient * p_sum[0];
    Components<T, D> a{};
    for (std::size_t k = 0; k < D; ++k) a[k] = -factor * r[k];
    return a;
}

/// What a particle of viscosity mu/rho0 brings to its pairs, pair_viscosity_sum's root.
template <class T>
RIFFLE_INLINE T viscosity_root(const T& viscosity) {
    using std::sqrt;
    using std::experimental::sqrt;
    return sqrt(scalar_of<T>(0.5) * viscosity);
}

/// Twice the viscosity of a pair from the roots of its particles, root = sqrt(mu/2): the square of the mean
/// root of mu. An eddy viscosity l_m^2 |S| then has the mean of the two mixing lengths, which is exact where
/// l_m grows linearly from the bed; the arithmetic mean of nu overestimates there, by (dz/z)^2.
template <class T>
RIFFLE_INLINE T pair_viscosity_sum(const T& root_i, const T& root_j) {
    const T sum = root_i + root_j;
    return sum * sum;
}

/// Viscosity in Morris' two-point form (Morris et al. 1997): V_j 2 mu_ij F u, 2 mu_ij from
/// pair_viscosity_sum.  A Laplacian, nu lap(u), for constant nu.
struct MorrisViscosity {
    template <class T, int D>
    RIFFLE_INLINE static Components<T, D> force(const T& volume_gradient, const T& viscosity_sum,
                                                const Components<T, D>& u, const Components<T, D>& r,
                                                const T& r_squared) {
        (void)r;
        (void)r_squared;
        const T factor = volume_gradient * viscosity_sum;
        Components<T, D> a{};
        for (std::size_t k = 0; k < D; ++k) a[k] = factor * u[k];
        return a;
    }
};

/// Morris' form with a weight of the pair's direction e = r/|r|, for an eddy viscosity that is another across
/// the channel (turbulence/czernuszenko_rylov.hpp): 2 mu_ij K_k of the velocity component k, K_k = level_k -
/// slope e_y^2, on the eddy part alone: sum K + molecular (1 - K).
template <class Real>
struct DirectionalViscosity {
    Real slope = Real(0);
    Real level = Real(1);         ///< of u and w
    Real level_across = Real(1);  ///< of v
    Real molecular = Real(0);     ///< 2 nu0, m2/s

    template <class T, int D>
    RIFFLE_INLINE Components<T, D> force(const T& volume_gradient, const T& viscosity_sum,
                                         const Components<T, D>& u, const Components<T, D>& r,
                                         const T& r_squared) const {
        static_assert(D == 3, "the spanwise direction is the second of three");
        const T across = slope * (r[1] * r[1]) / (r_squared + Real(1e-20));
        const T eddy = volume_gradient * (viscosity_sum - molecular);
        const T isotropic = volume_gradient * molecular;
        const T factor = isotropic + eddy * (level - across);
        const T factor_across = isotropic + eddy * (level_across - across);
        return {factor * u[0], factor_across * u[1], factor * u[2]};
    }
};

}  // namespace riffle::inline sph
