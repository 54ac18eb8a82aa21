#pragma once

// The gradient pass. Compiled once per instruction set, like pair_loops_impl.hpp.

#include "sph/cluster_turns.hpp"
#include "sph/correction.hpp"
#include "sph/kernel.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

/// What a pair adds to the continuity sum, at the middle of the straight way that the last step moved it: its
/// change of density over that step is then exact to the second order, where at the end of the way disorder
/// adds volume (docs/theory.md). `volume` is V_j.
template <int D, class Real, class Kernel>
RIFFLE_INLINE Wide<Real> midway_continuity(const Kernel& kernel, const Wide<Real>& volume,
                                           const Components<Wide<Real>, D>& u, Components<Wide<Real>, D> r,
                                           Real half_way) {
    using stdx::sqrt;
    for (std::size_t k = 0; k < D; ++k) r[k] -= half_way * u[k];
    const Wide<Real> distance = sqrt(dot<Wide<Real>, D>(r, r));
    return continuity<Wide<Real>, D>(kernel.gradient_shape(distance) * volume, u, r);
}

template <int D, class Real, class Kernel, bool Gradients, bool Midway>
[[gnu::flatten]] void gradient_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end,
                                    BlockWork<D, Real>& work) {
    using W = Wide<Real>;
    using T = Lanes<Real>;
    using stdx::sqrt;
    const PairConstants<D, Real> c = data.constants;
    const auto kernel = kernel_of<Kernel>(c);
    const Real scale = Kernel::template gradient_constant<Real>() * c.gradient_scale;
    const Real hydrostatic_gradient = c.hydrostatic_gradient * c.h;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const MotionRecord<D, Real>* own = &data.motion[cluster * cluster_size];
        const auto motion = own_motion<D, Real>(own);
        const OwnCluster<D, Real>& self = motion.first;
        const W& s = motion.second;

        W wide_diffusion(0);
        W wide_divergence(0);
        Components<W, D * D> wide_gradient{};
        Symmetric<W, D> wide_m{};
        for_turns<Real>(
            *data.fluid_fluid, cluster, work.slots.data(),
            [&](std::size_t slot_a, std::size_t slot_b, const std::int32_t* ahead) {
                prefetch<Real>(data.motion, ahead);
                const MotionRecord<D, Real>& a = data.motion[slot_a];
                const MotionRecord<D, Real>& b = data.motion[slot_b];
                const Components<W, D> r = self.distance(a, b, c);
                const W volume = halves<Real, Real>(a.volume, b.volume);
                const W weight = kernel.gradient_shape(W(sqrt(dot<W, D>(r, r)))) * volume;
                const Components<W, D> u = self.velocity(a, b);
                wide_diffusion += density_diffusion(weight, W(s - halves<Real, Real>(a.s, b.s)), r[D - 1],
                                                    hydrostatic_gradient);
                if constexpr (Gradients) {
                    for (std::size_t l = 0; l < D; ++l) {
                        const W gradient_l = weight * r[l];
                        for (std::size_t k = 0; k < D; ++k) wide_gradient[k * D + l] += u[k] * gradient_l;
                        for (std::size_t k = 0; k <= l; ++k) {
                            wide_m[symmetric_index<D>(static_cast<int>(k), static_cast<int>(l))] +=
                                r[k] * gradient_l;
                        }
                    }
                }
                if constexpr (Midway) {
                    wide_divergence += midway_continuity<D, Real>(kernel, volume, u, r, c.half_way);
                } else if constexpr (!Gradients) {
                    wide_divergence += continuity<W, D>(weight, u, r);
                }
            });
        const T diffusion = fold<Real>(wide_diffusion) * (Real(2) * scale * c.diffusion);
        // Of the pairs' sum V_j u.grad W; the trace of minus the velocity gradient.
        T divergence(0);
        const Components<T, D* D> gradient = fold_all<Real>(wide_gradient, -scale * c.h);
        Symmetric<T, D> m_fluid = fold_all<Real>(wide_m, -scale * c.h * c.h);
        if constexpr (Gradients && !Midway) {
            for (std::size_t k = 0; k < D; ++k) divergence -= gradient[k * D + k];
        } else {
            divergence = fold<Real>(wide_divergence) * (scale * c.h);
        }

        Symmetric<W, D> wide_m_wall{};       // walls whose pairs are not corrected
        Symmetric<W, D> wide_m_continued{};  // walls that continue the fluid
        Symmetric<W, D> wide_m_along{};      // those of them that do so along the channel too
        [[maybe_unused]] const bool continued_cluster =
            data.fluid_wall != nullptr && !data.correction[0].empty() &&
            data.fluid_wall->run_begin[cluster] < data.fluid_wall->run_begin[cluster + 1];
        if (data.fluid_wall != nullptr) {
            W wall_divergence(0);
            // Distance of the pairs with two wall particles, and the weight of their motion.
            const auto wall_pairs = [&](const WallGradientRecord<D, Real>& a,
                                        const WallGradientRecord<D, Real>& b) {
                struct {
                    Components<W, D> r;
                    W volume;
                    W weight;
                } pairs{self.distance(a, b, c), halves<Real, Real>(a.volume, b.volume), W(0)};
                pairs.weight = kernel.gradient_shape(W(sqrt(dot<W, D>(pairs.r, pairs.r)))) * pairs.volume;
                return pairs;
            };
            for_turns<Real>(
                *data.fluid_wall, cluster, work.slots.data(),
                [&](std::size_t slot_a, std::size_t slot_b, const std::int32_t* ahead) {
                    (void)ahead;
                    const WallGradientRecord<D, Real>& a = data.wall_gradient[slot_a];
                    const WallGradientRecord<D, Real>& b = data.wall_gradient[slot_b];
                    const auto [r, volume, weight] = wall_pairs(a, b);
                    Components<W, D> u{};
                    for (std::size_t k = 0; k < D; ++k) {
                        for (std::size_t l = 0; l < D; ++l) {
                            u[k] += self.u[l] *
                                    halves<Real, Real>(a.projector[k * D + l], b.projector[k * D + l]);
                        }
                    }
                    if constexpr (Midway) {
                        wall_divergence += midway_continuity<D, Real>(kernel, volume, u, r, c.half_way);
                    } else {
                        wall_divergence += continuity<W, D>(weight, u, r);
                    }
                    if constexpr (Gradients) {
                        const W continued =
                            weight * halves<Real, Real>(a.continuation.back(), b.continuation.back());
                        [[maybe_unused]] const W along =
                            weight * halves<Real, Real>(a.continuation.front(), b.continuation.front());
                        for (std::size_t l = 0; l < D; ++l) {
                            for (std::size_t k = 0; k <= l; ++k) {
                                const std::size_t kl =
                                    symmetric_index<D>(static_cast<int>(k), static_cast<int>(l));
                                wide_m_continued[kl] += continued * r[k] * r[l];
                                if constexpr (D == 3) wide_m_along[kl] += along * r[k] * r[l];
                                wide_m_wall[kl] += (weight - continued) * r[k] * r[l];
                            }
                        }
                    }
                });
            if (!data.wall_drift.empty()) {
                for_turns<Real>(
                    *data.fluid_wall, cluster, work.slots.data(),
                    [&](std::size_t slot_a, std::size_t slot_b, const std::int32_t* ahead) {
                        (void)ahead;
                        const auto [r, volume, weight] =
                            wall_pairs(data.wall_gradient[slot_a], data.wall_gradient[slot_b]);
                        Components<W, D> u{};
                        for (std::size_t k = 0; k < D; ++k) {
                            u[k] = halves<Real, Real>(data.wall_drift[slot_a][k], data.wall_drift[slot_b][k]);
                        }
                        if constexpr (Midway) {
                            wall_divergence -= midway_continuity<D, Real>(kernel, volume, u, r, c.half_way);
                        } else {
                            wall_divergence -= continuity<W, D>(weight, u, r);
                        }
                    });
            }
            divergence += fold<Real>(wall_divergence) * (scale * c.h);
        }

        const std::size_t lane = (cluster - begin) * cluster_size;
        store_lanes(divergence, &work.gradient.density_rate[lane]);
        store_lanes(diffusion, &work.gradient.diffusion[lane]);
        if constexpr (Gradients) {
            // The corrected gradient G M_fluid^-1 is exact for linear fields as long as M_fluid can be
            // inverted.
            const T gradient_blend =
                c.correct_gradient && !work.uncorrected_gradient
                    ? smoothstep<T>(Real(0.1), Real(0.3), smallest_eigenvalue<T, D>(m_fluid))
                    : T(0);
            const Components<T, D* D> gradient_matrix =
                pressure_correction<T, D>(m_fluid, Symmetric<T, D>{}, gradient_blend);

            const Symmetric<T, D> m_wall = fold_all<Real>(wide_m_wall, -scale * c.h * c.h);
            [[maybe_unused]] Symmetric<T, D> m_water = m_fluid;
            const Symmetric<T, D> m_continued = fold_all<Real>(wide_m_continued, -scale * c.h * c.h);
            add(m_fluid, m_continued);
            Symmetric<T, D> m_total = m_fluid;
            add(m_total, m_wall);
            const T regularity = smallest_eigenvalue<T, D>(m_total);
            const T pressure_blend =
                c.correct_pressure ? smoothstep<T>(Real(0.6), Real(0.9), regularity) : T(0);
            Components<T, D* D> b = pressure_correction<T, D>(m_fluid, m_wall, pressure_blend);
            if constexpr (D == 3) {
                if (continued_cluster) {
                    // Along the channel fewer walls continue the fluid (Continuation).
                    const Symmetric<T, D> m_along = fold_all<Real>(wide_m_along, -scale * c.h * c.h);
                    Symmetric<T, D> across = m_continued;
                    subtract(across, m_along);
                    Symmetric<T, D> walls = m_wall;
                    add(walls, across);
                    add(m_water, m_along);
                    const Components<T, D* D> along =
                        pressure_correction<T, D>(m_water, walls, pressure_blend);
                    std::copy_n(along.begin(), D, b.begin());
                }
            }

            for (std::size_t k = 0; k < D; ++k) {
                for (std::size_t l = 0; l < D; ++l) {
                    T sum = gradient[k * D] * gradient_matrix[l];
                    for (std::size_t m = 1; m < D; ++m) {
                        sum += gradient[k * D + m] * gradient_matrix[m * D + l];
                    }
                    store_lanes(sum, &work.gradient.velocity_gradient[k * D + l][lane]);
                    store_lanes(b[k * D + l], &work.gradient.correction[k * D + l][lane]);
                }
            }
            // The two-point viscosity is nu M_kl d2u/dx_k dx_l. Among disordered particles tr(M)/D falls
            // below one, and Taylor-Green vortices decay 1 to 2 % too slowly; this factor puts that right.
            T trace = m_total[0];
            for (int k = 1; k < D; ++k) trace += m_total[symmetric_index<D>(k, k)];
            // (Of a lone drop the trace is zero, and the blend too.)
            store_lanes(T(Real(1) + pressure_blend * (Real(D) / stdx::max(trace, T(1)) - Real(1))),
                        &work.gradient.viscosity_factor[lane]);
            store_lanes(regularity, &work.gradient.regularity[lane]);
        }
    }
}

}  // namespace riffle::inline sph::RIFFLE_ISA
