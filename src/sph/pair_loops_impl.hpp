#pragma once

// The loops themselves. This header is compiled once per instruction set, inside a namespace of its own
// (RIFFLE_ISA), so that the linker never mixes their code.
//
// Distances are measured in smoothing lengths, and the constant factors of a sum (the kernel's constant,
// powers of h) multiply the sum, not each of its terms.

#include <algorithm>
#include <utility>

#include "sph/correction.hpp"
#include "sph/kernel.hpp"
#include "sph/pair_loops.hpp"
#include "sph/pair_terms.hpp"
#include "sph/record_lanes.hpp"
#include "sph/tabulated_kernel.hpp"
#include "sph/wide.hpp"

namespace riffle::RIFFLE_ISA {

/// The i side of a cluster and what its turns need.
template <int D, class Real>
struct OwnCluster {
    Components<WideInteger<Real>, D> x;
    Components<Wide<Real>, D> u;

    template <class Record>
    RIFFLE_INLINE explicit OwnCluster(const Record* records) {
        for (std::size_t k = 0; k < D; ++k) {
            x[k] = gather<Real, std::int32_t>(records, [k](const Record& r) { return r.x[k]; });
            u[k] = gather<Real, Real>(records, [k](const Record& r) { return r.u[k]; });
        }
    }

    /// Of words in the order of MotionRecord and WallForceRecord: positions, then velocities.
    template <std::size_t N>
    RIFFLE_INLINE explicit OwnCluster(const std::array<Lanes<float>, N>& words) {
#ifdef __AVX2__
        for (std::size_t k = 0; k < D; ++k) {
            x[k] = both_halves<std::int32_t, Real>(integers_of(words[k]));
            u[k] = both_halves<Real, Real>(words[D + k]);
        }
#else
        (void)words;
#endif
    }

    /// r = x_i - x_j in smoothing lengths for the neighbours of a turn.
    template <class Record>
    RIFFLE_INLINE Components<Wide<Real>, D> distance(const Record& a, const Record& b,
                                                     const PairConstants<D, Real>& c) const {
        Components<Wide<Real>, D> r{};
        for (std::size_t k = 0; k < D; ++k) {
            const WideInteger<Real> difference = x[k] - halves<Real, std::int32_t>(a.x[k], b.x[k]);
            r[k] = stdx::static_simd_cast<Wide<Real>>(difference) * c.unit[k];
        }
        return r;
    }

    /// u_i - u_j.
    template <class Record>
    RIFFLE_INLINE Components<Wide<Real>, D> velocity(const Record& a, const Record& b) const {
        Components<Wide<Real>, D> difference{};
        for (std::size_t k = 0; k < D; ++k) {
            difference[k] = u[k] - halves<Real, Real>(a.u[k], b.u[k]);
        }
        return difference;
    }
};

/// The i side of a cluster from its motion records, and their density deviation.
template <int D, class Real>
RIFFLE_INLINE std::pair<OwnCluster<D, Real>, Wide<Real>> own_motion(const MotionRecord<D, Real>* records) {
    if constexpr (records_in_registers<MotionRecord<D, Real>, Real>()) {
        const auto words = load_records(records);
        return {OwnCluster<D, Real>(words), both_halves<Real, Real>(words[2 * D])};
    } else {
        return {OwnCluster<D, Real>(records), gather<Real, Real>(records, [](const auto& r) { return r.s; })};
    }
}

/// The stress and the viscosity root of a cluster.
template <class Real, class Record>
RIFFLE_INLINE auto own_stress(const Record* records) {
    constexpr std::size_t components = std::tuple_size_v<decltype(Record::stress)>;
    std::pair<Components<Wide<Real>, components>, Wide<Real>> own{};
    if constexpr (records_in_registers<Record, Real>()) {
        const auto words = load_records(records);
        for (std::size_t k = 0; k < components; ++k) {
            own.first[k] = both_halves<Real, Real>(words[k]);
        }
        own.second = both_halves<Real, Real>(words[components]);
    } else {
        for (std::size_t k = 0; k < components; ++k) {
            own.first[k] = gather<Real, Real>(records, [k](const auto& r) { return r.stress[k]; });
        }
        own.second = gather<Real, Real>(records, [](const auto& r) { return r.viscosity_root; });
    }
    return own;
}

template <std::size_t N, class T>
RIFFLE_INLINE void add(std::array<T, N>& sum, const std::array<T, N>& term) {
    for (std::size_t k = 0; k < N; ++k) {
        sum[k] += term[k];
    }
}

template <std::size_t N, class T>
RIFFLE_INLINE void subtract(std::array<T, N>& sum, const std::array<T, N>& term) {
    for (std::size_t k = 0; k < N; ++k) {
        sum[k] -= term[k];
    }
}

/// The folded sums times a factor.
template <class Real, std::size_t N>
RIFFLE_INLINE std::array<Lanes<Real>, N> fold_all(const std::array<Wide<Real>, N>& sums, Real factor) {
    std::array<Lanes<Real>, N> result{};
    for (std::size_t k = 0; k < N; ++k) {
        result[k] = fold<Real>(sums[k]) * factor;
    }
    return result;
}

/// NeighbourList::spell()'s writer in lanes.
struct LaneWriter {
    RIFFLE_INLINE static void bits(std::int32_t base, std::uint8_t mask, std::int32_t* to) {
        store_lanes(Lanes<std::int32_t>(Lanes<std::int32_t>(base) + bit_positions(mask)), to);
    }
    RIFFLE_INLINE static void same(std::int32_t value, std::int32_t* to) {
        store_lanes(Lanes<std::int32_t>(value), to);
    }
};

/// Call f(slot_a, slot_b, ahead) for the turns of a cluster's list; `ahead` is a slot of a later turn, to
/// fetch.
template <class Real, class F>
RIFFLE_INLINE void for_turns(const NeighbourList& list, std::size_t cluster, std::int32_t* slots,
                             const F& f) {
    const std::size_t count = list.spell(cluster, slots, LaneWriter{});
    for (std::size_t n = 0; n < count; n += neighbours_per_turn<Real>) {
        f(static_cast<std::size_t>(slots[n]),
          static_cast<std::size_t>(slots[n + neighbours_per_turn<Real> - 1]),
          &slots[n + NeighbourList::lookahead]);
    }
}

/// Fetch the records of the turn that `ahead` points to.
template <class Real, class Record>
RIFFLE_INLINE void prefetch(const std::vector<Record>& records, const std::int32_t* ahead) {
    for (std::size_t n = 0; n < neighbours_per_turn<Real>; ++n) {
        const char* record = reinterpret_cast<const char*>(records.data() + ahead[n]);
        __builtin_prefetch(record);
        if constexpr (sizeof(Record) > 64) {
            __builtin_prefetch(record + 64);
        }
    }
}

/// A kernel with what it needs of the constants.
template <class Kernel, int D, class Real>
RIFFLE_INLINE Kernel kernel_of(const PairConstants<D, Real>& c) {
    if constexpr (std::is_same_v<Kernel, TabulatedKernel<Real>>) {
        return {*c.table};
    } else {
        static_cast<void>(c);
        return {};
    }
}

/// What a pair adds to the continuity sum, at the middle of the straight way that the last step moved it: its
/// change of density over that step is then exact to the second order, where at the end of the way disorder
/// adds volume (docs/theory.md). `volume` is V_j.
template <int D, class Real, class Kernel>
RIFFLE_INLINE Wide<Real> midway_continuity(const Kernel& kernel, const Wide<Real>& volume,
                                           const Components<Wide<Real>, D>& u, Components<Wide<Real>, D> r,
                                           Real half_way) {
    using stdx::sqrt;
    for (std::size_t k = 0; k < D; ++k) {
        r[k] -= half_way * u[k];
    }
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
                        for (std::size_t k = 0; k < D; ++k) {
                            wide_gradient[k * D + l] += u[k] * gradient_l;
                        }
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
            for (std::size_t k = 0; k < D; ++k) {
                divergence -= gradient[k * D + k];
            }
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
                                if constexpr (D == 3) {
                                    wide_m_along[kl] += along * r[k] * r[l];
                                }
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
            for (int k = 1; k < D; ++k) {
                trace += m_total[symmetric_index<D>(k, k)];
            }
            // (Of a lone drop the trace is zero, and the blend too.)
            store_lanes(T(Real(1) + pressure_blend * (Real(D) / stdx::max(trace, T(1)) - Real(1))),
                        &work.gradient.viscosity_factor[lane]);
            store_lanes(regularity, &work.gradient.regularity[lane]);
        }
    }
}

/// The records of the stress in a form.
template <class Record, int D, class Real>
RIFFLE_INLINE const std::vector<Record>& stress_records(const PairData<D, Real>& data) {
    if constexpr (std::is_same_v<Record, PressureRecord<Real>>) {
        return data.pressure;
    } else {
        return data.stress;
    }
}

/// The form of the viscosity with its constants.
template <class Viscosity, int D, class Real>
RIFFLE_INLINE Viscosity viscosity_of(const PairConstants<D, Real>& c) {
    if constexpr (std::is_same_v<Viscosity, DirectionalViscosity<Real>>) {
        return c.directional;
    } else if constexpr (std::is_same_v<Viscosity, PairForm<Real>>) {
        return c.form;
    } else {
        static_cast<void>(c);
        return {};
    }
}

/// Whether the kernel is one that Monaghan's repulsion against clumping goes with.
template <class Kernel, int D>
inline constexpr bool may_repel = std::is_same_v<Kernel, CubicSpline<D>>;

template <int D, class Real, class Kernel, class Viscosity, class Record>
[[gnu::flatten]] void force_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end,
                                 BlockWork<D, Real>& work) {
    using W = Wide<Real>;
    using stdx::sqrt;
    constexpr std::size_t components = std::tuple_size_v<decltype(Record::stress)>;
    constexpr bool further = std::is_same_v<Viscosity, PairForm<Real>>;
    const PairConstants<D, Real> c = data.constants;
    const auto form = viscosity_of<Viscosity>(c);
    const auto kernel = kernel_of<Kernel>(c);
    const Real scale = Kernel::template gradient_constant<Real>() * c.gradient_scale;
    const std::vector<Record>& records = stress_records<Record>(data);
    const NeighbourList& fluid_list = *(work.fluid_fluid != nullptr ? work.fluid_fluid : data.fluid_fluid);
    const NeighbourList* const wall_list = work.fluid_wall != nullptr ? work.fluid_wall : data.fluid_wall;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t slot = cluster * cluster_size;
        const Record* own = &records[slot];
        const auto motion = own_motion<D, Real>(&data.motion[slot]);
        const OwnCluster<D, Real>& self = motion.first;
        [[maybe_unused]] const W& s = motion.second;
        const auto stress_and_root = own_stress<Real>(own);
        const Components<W, components>& stress = stress_and_root.first;
        const W& root = stress_and_root.second;
        [[maybe_unused]] W own_pressure(0);
        if constexpr (further) {
            own_pressure = gather<Real, Real>(own, [](const auto& r) { return r.pressure; });
        }

        Components<W, D> tensor{};
        Components<W, D> viscous{};
        for_turns<Real>(
            fluid_list, cluster, work.slots.data(),
            [&](std::size_t slot_a, std::size_t slot_b, const std::int32_t* ahead) {
                prefetch<Real>(data.motion, ahead);
                prefetch<Real>(records, ahead);
                const Components<W, D> r = self.distance(data.motion[slot_a], data.motion[slot_b], c);
                const Components<W, D> u = self.velocity(data.motion[slot_a], data.motion[slot_b]);
                const Record& a = records[slot_a];
                const Record& b = records[slot_b];
                const W r_squared = dot<W, D>(r, r);
                const W distance = sqrt(r_squared);
                const W weight = kernel.gradient_shape(distance) * halves<Real, Real>(a.weight, b.weight);
                Components<W, components> stress_sum{};
                for (std::size_t k = 0; k < components; ++k) {
                    stress_sum[k] = stress[k] + halves<Real, Real>(a.stress[k], b.stress[k]);
                }
                add(tensor, tensor_force<W, D>(weight, stress_sum, r));
                if constexpr (further) {
                    const W density = Real(1) + Real(0.5) * (s + halves<Real, Real>(data.motion[slot_a].s,
                                                                                    data.motion[slot_b].s));
                    W more = form.template dissipation<W, D>(density, u, r, distance) -
                             form.non_conservative * own_pressure;
                    if constexpr (may_repel<Kernel, D>) {
                        if (form.tensile > Real(0)) {
                            more += form.template repulsion<W>(own_pressure,
                                                               halves<Real, Real>(a.pressure, b.pressure),
                                                               kernel.value(distance));
                        }
                    }
                    add(tensor, tensor_force<W, D>(weight, Components<W, 1>{more}, r));
                }
                const W viscosity =
                    pair_viscosity_sum<W>(root, halves<Real, Real>(a.viscosity_root, b.viscosity_root));
                add(viscous, form.template force<W, D>(weight, viscosity, u, r, r_squared));
            });

        Components<W, D> wall_tensor{};
        Components<W, D> wall_viscous{};
        if (wall_list != nullptr) {
            // (p_i + p_j) I, or (p_i + p_j) B_i as far as the wall continues the fluid.
            const W pressure =
                data.pair_pressure.empty()
                    ? gather<Real, Real>(own, [](const auto& r) { return r.pressure; })
                    : gather<Real, Real>(&data.pair_pressure[slot], [](const Real& p) { return p; });
            const std::int32_t correction_lane = data.correction_of(cluster);
            const bool continued = correction_lane >= 0;
            Components<W, D * D> departure{};
            if (continued) {
                for (std::size_t k = 0; k < departure.size(); ++k) {
                    const Real identity = k % (D + 1) == 0 ? Real(1) : Real(0);
                    departure[k] =
                        gather<Real, Real>(&data.correction[k][static_cast<std::size_t>(correction_lane)],
                                           [](const Real& b) { return b; }) -
                        identity;
                }
            }
            for_turns<Real>(
                *wall_list, cluster, work.slots.data(),
                [&](std::size_t slot_a, std::size_t slot_b, const std::int32_t* ahead) {
                    (void)ahead;
                    const WallForceRecord<D, Real>& a = data.wall_force[slot_a];
                    const WallForceRecord<D, Real>& b = data.wall_force[slot_b];
                    const Components<W, D> r = self.distance(a, b, c);
                    const Components<W, D> u = self.velocity(a, b);
                    const W r_squared = dot<W, D>(r, r);
                    const W distance = sqrt(r_squared);
                    const W shape = kernel.gradient_shape(distance);
                    const W weight = shape * halves<Real, Real>(a.weight, b.weight);
                    const W wall_pressure = halves<Real, Real>(a.pressure, b.pressure);
                    W pressure_sum = pressure + wall_pressure;
                    if constexpr (further) {
                        pressure_sum -= form.non_conservative * pressure;
                    }
                    if constexpr (further && may_repel<Kernel, D>) {
                        if (form.tensile > Real(0)) {
                            pressure_sum +=
                                form.template repulsion<W>(pressure, wall_pressure, kernel.value(distance));
                        }
                    }
                    add(wall_tensor, tensor_force<W, D>(weight, Components<W, 1>{pressure_sum}, r));
                    if (continued) {
                        const W along =
                            pressure_sum * halves<Real, Real>(a.continuation.front(), b.continuation.front());
                        const W across =
                            pressure_sum * halves<Real, Real>(a.continuation.back(), b.continuation.back());
                        Components<W, D * D> stress_sum{};
                        for (std::size_t k = 0; k < stress_sum.size(); ++k) {
                            stress_sum[k] = (k < D ? along : across) * departure[k];
                        }
                        add(wall_tensor, tensor_force<W, D>(weight, stress_sum, r));
                    }
                    const W viscosity =
                        pair_viscosity_sum<W>(root, halves<Real, Real>(a.viscosity_root, b.viscosity_root));
                    add(wall_viscous, form.template force<W, D>(
                                          W(shape * halves<Real, Real>(a.viscous_weight, b.viscous_weight)),
                                          viscosity, u, r, r_squared));
                });
        }
        const std::size_t lane = (cluster - begin) * cluster_size;
        const auto fluid_tensor = fold_all<Real>(tensor, scale * c.h);
        const auto fluid_viscous = fold_all<Real>(viscous, scale);
        const auto all_wall_tensor = fold_all<Real>(wall_tensor, scale * c.h);
        const auto all_wall_viscous = fold_all<Real>(wall_viscous, scale);
        for (std::size_t k = 0; k < D; ++k) {
            store_lanes(Lanes<Real>(fluid_tensor[k] + all_wall_tensor[k]), &work.force.tensor[k][lane]);
            store_lanes(Lanes<Real>(fluid_viscous[k] + all_wall_viscous[k]), &work.force.viscous[k][lane]);
            store_lanes(Lanes<Real>(all_wall_tensor[k] + all_wall_viscous[k]), &work.force.wall[k][lane]);
        }
    }
}

template <int D, class Real, class Kernel, class Record>
[[gnu::flatten]] void wall_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end,
                                BlockWork<D, Real>& work) {
    using W = Wide<Real>;
    using stdx::sqrt;
    const PairConstants<D, Real> c = data.constants;
    const auto kernel = kernel_of<Kernel>(c);
    const Real scale = Kernel::template gradient_constant<Real>() * c.gradient_scale;
    const std::vector<Record>& records = stress_records<Record>(data);
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const OwnCluster<D, Real> self(&data.wall_force[cluster * cluster_size]);
        W weight(0);
        W pressure(0);
        W density_rate(0);
        Components<W, D> offset{};
        Components<W, D> velocity{};
        for_turns<Real>(*data.wall_fluid, cluster, work.slots.data(),
                        [&](std::size_t slot_a, std::size_t slot_b, const std::int32_t* ahead) {
                            (void)ahead;
                            const MotionRecord<D, Real>& a = data.motion[slot_a];
                            const MotionRecord<D, Real>& b = data.motion[slot_b];
                            const Components<W, D> r = self.distance(a, b, c);
                            const W q = sqrt(dot<W, D>(r, r));
                            // The record that fills a turn up has no volume: it must not count here either.
                            const W volume = halves<Real, Real>(a.volume, b.volume);
                            W w = kernel.value(q);
                            stdx::where(volume == W(0), w) = W(0);
                            weight += w;
                            pressure +=
                                w * halves<Real, Real>(records[slot_a].pressure, records[slot_b].pressure);
                            Components<W, D> u{};
                            for (std::size_t k = 0; k < D; ++k) {
                                offset[k] += w * r[k];
                                u[k] = halves<Real, Real>(a.u[k], b.u[k]);
                                velocity[k] += w * u[k];
                            }
                            density_rate -= continuity<W, D>(kernel.gradient_shape(q) * volume, u, r);
                        });
        const std::size_t lane = (cluster - begin) * cluster_size;
        store_lanes(fold<Real>(weight), &work.wall.weight[lane]);
        store_lanes(fold<Real>(pressure), &work.wall.pressure[lane]);
        store_lanes(Lanes<Real>(fold<Real>(density_rate) * (scale * c.h)), &work.wall.density_rate[lane]);
        for (std::size_t k = 0; k < D; ++k) {
            store_lanes(Lanes<Real>(fold<Real>(offset[k]) * c.h), &work.wall.offset[k][lane]);
            store_lanes(fold<Real>(velocity[k]), &work.wall.velocity[k][lane]);
        }
    }
}

template <int D, class Real, class Kernel>
[[gnu::flatten]] void filter_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end,
                                  BlockWork<D, Real>& work) {
    using W = Wide<Real>;
    using stdx::sqrt;
    const PairConstants<D, Real> c = data.constants;
    const auto kernel = kernel_of<Kernel>(c);
    const Real kernel_scale = c.gradient_scale * c.h * c.h;  // h^-D
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const OwnCluster<D, Real> self(&data.motion[cluster * cluster_size]);
        W zeroth(0);
        W mass(0);
        Components<W, D> first{};
        Components<W, D> mass_first{};
        Components<W, D> velocity{};
        Symmetric<W, D> second{};
        for_turns<Real>(*data.fluid_fluid, cluster, work.slots.data(),
                        [&](std::size_t slot_a, std::size_t slot_b, const std::int32_t* ahead) {
                            prefetch<Real>(data.motion, ahead);
                            const MotionRecord<D, Real>& a = data.motion[slot_a];
                            const MotionRecord<D, Real>& b = data.motion[slot_b];
                            const Components<W, D> r = self.distance(a, b, c);
                            const W w = kernel.value(W(sqrt(dot<W, D>(r, r)))) *
                                        halves<Real, Real>(a.volume, b.volume);
                            const W mass_weight = w * (Real(1) + halves<Real, Real>(a.s, b.s));
                            zeroth += w;
                            mass += mass_weight;
                            const Components<W, D> u = self.velocity(a, b);
                            for (std::size_t k = 0; k < D; ++k) {
                                first[k] += w * r[k];
                                mass_first[k] += mass_weight * r[k];
                                velocity[k] -= w * u[k];
                                for (std::size_t l = k; l < D; ++l) {
                                    second[symmetric_index<D>(static_cast<int>(k), static_cast<int>(l))] +=
                                        w * r[k] * r[l];
                                }
                            }
                        });
        const std::size_t lane = (cluster - begin) * cluster_size;
        const auto store = [&](const W& sum, Real factor, LaneArray<Real>& result) {
            store_lanes(Lanes<Real>(fold<Real>(sum) * (kernel_scale * factor)), &result[lane]);
        };
        store(zeroth, Real(1), work.filter.zeroth);
        store(mass, Real(1), work.filter.mass);
        for (std::size_t k = 0; k < D; ++k) {
            store(first[k], c.h, work.filter.first[k]);
            store(mass_first[k], c.h, work.filter.mass_first[k]);
            store(velocity[k], Real(1), work.filter.velocity[k]);
        }
        for (std::size_t k = 0; k < second.size(); ++k) {
            store(second[k], c.h * c.h, work.filter.second[k]);
        }
    }
}

template <int D, class Real, class Kernel, class Record>
PairLoops<D, Real> loops_of(const LoopOptions& options) {
    constexpr bool gradients = std::is_same_v<Record, StressRecord<D, Real>>;
    PairLoops<D, Real> loops{};
    loops.gradient = &gradient_loop<D, Real, Kernel, gradients, false>;
    loops.gradient_midway = &gradient_loop<D, Real, Kernel, gradients, true>;
    loops.force = &force_loop<D, Real, Kernel, PairForm<Real>, Record>;
    if constexpr (!std::is_same_v<Kernel, TabulatedKernel<Real>>) {
        if (!needs_pair_form(options)) {
            loops.force = &force_loop<D, Real, Kernel, MorrisViscosity, Record>;
            if constexpr (D == 3 && gradients) {
                if (options.directional) {
                    loops.force = &force_loop<D, Real, Kernel, DirectionalViscosity<Real>, Record>;
                }
            }
        }
    }
    loops.wall = &wall_loop<D, Real, Kernel, Record>;
    loops.filter = &filter_loop<D, Real, Kernel>;
    return loops;
}

template <int D, class Real, class Kernel>
PairLoops<D, Real> loops_with(const LoopOptions& options) {
    return options.gradients ? loops_of<D, Real, Kernel, StressRecord<D, Real>>(options)
                             : loops_of<D, Real, Kernel, PressureRecord<Real>>(options);
}

template <int D, class Real>
PairLoops<D, Real> loops(const LoopOptions& options) {
    static_assert(has_own_loops(KernelKind::wendland_c2) && has_own_loops(KernelKind::cubic_spline));
    return options.kernel == KernelKind::wendland_c2    ? loops_with<D, Real, WendlandC2<D>>(options)
           : options.kernel == KernelKind::cubic_spline ? loops_with<D, Real, CubicSpline<D>>(options)
                                                        : loops_with<D, Real, TabulatedKernel<Real>>(options);
}

}  // namespace riffle::RIFFLE_ISA
