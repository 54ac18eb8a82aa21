#pragma once

#include <cmath>
#include <limits>

#include "case/options.hpp"
#include "sph/pair_terms.hpp"

namespace riffle::inline sph {

/// The terms of a pair that only some schemes have, chosen by numbers instead of types: one set of loops
/// serves them all. The forms of the default scheme have loops of their own. Lengths are in smoothing
/// lengths.
template <class Real>
struct PairForm {
    // Viscosity: V_j 2 mu_ij F [laplacian r^2 u + line_of_centres min(u.r, opening_limit) r]/(r^2 +
    // softening).
    Real laplacian = Real(1);
    Real line_of_centres = Real(0);
    Real opening_limit = std::numeric_limits<Real>::max();  ///< 0: between approaching particles alone
    Real softening = Real(1e-20);                           ///< (eta/h)^2
    bool by_direction = false;  ///< the weights of `direction` instead (three dimensions)
    DirectionalViscosity<Real> direction = {};

    // Pressure, added to (p_i + p_j)/rho0.
    Real impact = Real(0);            ///< 3: dissipation of the Riemann problem; 0: none
    Real impact_bound = Real(0);      ///< of impact times the speed of approach, m/s
    Real non_conservative = Real(0);  ///< 2: the particle's own pressure taken off twice, p_j - p_i; 0: not
    Real tensile = Real(0);           ///< epsilon of Monaghan (2000); 0: none
    Real tensile_scale = Real(0);     ///< 1/W(dx)

    template <class T, int D>
    RIFFLE_INLINE Components<T, D> force(const T& volume_gradient, const T& viscosity_sum,
                                         const Components<T, D>& u, const Components<T, D>& r,
                                         const T& r_squared) const {
        using std::min;
        using std::experimental::min;
        if constexpr (D == 3) {
            if (by_direction) {
                return direction.template force<T, D>(volume_gradient, viscosity_sum, u, r, r_squared);
            }
        }
        const T factor = volume_gradient * viscosity_sum / (r_squared + softening);
        const T of_velocity = laplacian * (factor * r_squared);
        const T of_distance = line_of_centres * (factor * min(dot<T, D>(u, r), T(opening_limit)));
        Components<T, D> a{};
        for (std::size_t k = 0; k < D; ++k) a[k] = of_velocity * u[k] + of_distance * r[k];
        return a;
    }

    /// Riemann problem along the line of centres, linearised (Zhang, Hu & Adams 2017): 2 p*/rho0 = (p_i +
    /// p_j)/rho0 + (rho_ij/rho0) beta v, v = -u.r/r the velocity of approach, beta = min(impact max(v, 0),
    /// bound), bound = c0 in their paper. What it adds to the sum of the pressures; `density` is rho_ij/rho0.
    template <class T, int D>
    RIFFLE_INLINE T dissipation(const T& density, const Components<T, D>& u, const Components<T, D>& r,
                                const T& distance) const {
        using std::min;
        using std::experimental::min;
        const T approach = positive_part<T>(T(Real(0) - dot<T, D>(u, r) / (distance + Real(1e-12))));
        return density * approach * min(T(impact * approach), T(impact_bound));
    }

    /// Monaghan's (2000) repulsion against clumping, R f^4 with f = W(r)/W(dx), of P = p/rho^2 rho0: R = 0.01
    /// (P_i + P_j) between two particles under pressure, else epsilon times the magnitudes of the negative
    /// ones.
    template <class T>
    RIFFLE_INLINE T repulsion(const T& pressure_i, const T& pressure_j, const T& kernel) const {
        const T suction = positive_part<T>(T(-pressure_i)) + positive_part<T>(T(-pressure_j));
        T r = T(Real(0.01) * (pressure_i + pressure_j));
        if constexpr (std::is_same_v<T, Real>) {
            r = suction > Real(0) ? tensile * suction : r;
        } else {
            where(suction > T(0), r) = tensile * suction;
        }
        const T f = kernel * tensile_scale;
        const T f2 = f * f;
        return r * (f2 * f2);
    }
};

/// The viscosity of a case's choice in D dimensions. That along the line of centres (Monaghan & Gingold 1983;
/// Monaghan 2005) keeps the angular momentum, and its natural surface condition is zero traction.
/// `artificial` expects the viscosity alpha h c0/2 in the roots of the particles.
template <int D, class Real>
[[nodiscard]] PairForm<Real> viscosity_form(ViscosityForm viscosity) {
    PairForm<Real> form;
    switch (viscosity) {
        case ViscosityForm::morris:
            break;
        case ViscosityForm::monaghan_gingold:
            form.laplacian = Real(0);
            form.line_of_centres = Real(D + 2);
            break;
        case ViscosityForm::lo_shao:
            form.softening = Real(0.01);
            break;
        case ViscosityForm::artificial:
            form.laplacian = Real(0);
            form.line_of_centres = Real(1);
            form.opening_limit = Real(0);
            form.softening = Real(0.01);
            break;
    }
    return form;
}

}  // namespace riffle::inline sph
