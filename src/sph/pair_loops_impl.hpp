#pragma once

// The loops themselves. This header is compiled once per instruction set, inside a namespace of its own
// (RIFFLE_ISA), so that the linker never mixes their code.

#include <experimental/simd>

#include "sph/correction.hpp"
#include "sph/kernel_registry.hpp"
#include "sph/pair_loops.hpp"
#include "sph/pair_terms.hpp"

namespace riffle::RIFFLE_ISA {

namespace stdx = std::experimental;
using IntLanes = stdx::fixed_size_simd<std::int32_t, cluster_size>;

/// How far ahead in the list records are fetched into the cache.
inline constexpr std::size_t prefetch_distance = 16;

/// Positions of a cluster in integer units.
template <int D>
struct LanePositions {
    std::array<IntLanes, static_cast<std::size_t>(D)> x;

    /// Distances r = x_i - x_j in metres to one record.
    template <class Real>
    RIFFLE_INLINE Components<Lanes<Real>, D> to(
        const std::array<std::int32_t, static_cast<std::size_t>(D)>& xj,
        const std::array<Real, static_cast<std::size_t>(D)>& unit) const {
        Components<Lanes<Real>, D> r{};
        for (std::size_t k = 0; k < D; ++k) {
            r[k] = stdx::static_simd_cast<Lanes<Real>>(x[k] - IntLanes(xj[k])) * unit[k];
        }
        return r;
    }
};

/// Gather one field of the 8 records of a cluster into lanes.
template <class Value, class Record, class Get>
RIFFLE_INLINE auto gather(const Record* records, const Get& get) {
    alignas(64) std::array<Value, cluster_size> values;
    for (std::size_t l = 0; l < cluster_size; ++l) {
        values[l] = get(records[l]);
    }
    return stdx::fixed_size_simd<Value, cluster_size>(values.data(), stdx::element_aligned);
}

template <int D, class Record>
RIFFLE_INLINE LanePositions<D> gather_positions(const Record* records) {
    LanePositions<D> positions;
    for (std::size_t k = 0; k < D; ++k) {
        positions.x[k] = gather<std::int32_t>(records, [k](const Record& r) { return r.x[k]; });
    }
    return positions;
}

template <int D, class Real, class Record>
RIFFLE_INLINE Components<Lanes<Real>, D> gather_velocities(const Record* records) {
    Components<Lanes<Real>, D> u{};
    for (std::size_t k = 0; k < D; ++k) {
        u[k] = gather<Real>(records, [k](const Record& r) { return r.u[k]; });
    }
    return u;
}

template <std::size_t N, class T>
RIFFLE_INLINE void add(std::array<T, N>& sum, const std::array<T, N>& term) {
    for (std::size_t k = 0; k < N; ++k) {
        sum[k] += term[k];
    }
}

template <class Record>
RIFFLE_INLINE void prefetch(const std::vector<Record>& records, std::span<const std::int32_t> list,
                            std::size_t k) {
    const std::size_t ahead = k + prefetch_distance < list.size() ? k + prefetch_distance : list.size() - 1;
    __builtin_prefetch(&records[static_cast<std::size_t>(list[ahead])]);
}

template <int D, class Real, class Kernel>
[[gnu::flatten]] void gradient_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end) {
    using T = Lanes<Real>;
    using std::experimental::sqrt;
    const PairConstants<D, Real> c = data.constants;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t slot = cluster * cluster_size;
        const GradientRecord<D, Real>* own = &data.fluid_gradient[slot];
        const LanePositions<D> position = gather_positions<D>(own);
        const Components<T, D> velocity = gather_velocities<D, Real>(own);
        const T s = gather<Real>(own, [](const auto& r) { return r.s; });

        T divergence = T(0);
        T diffusion = T(0);
        Components<T, D * D> gradient{};
        Symmetric<T, D> m_fluid{};
        Symmetric<T, D> m_wall{};       // walls whose pairs are not corrected
        Symmetric<T, D> m_continued{};  // walls that continue the fluid

        const auto list = data.fluid_fluid->of(cluster);
        for (std::size_t n = 0; n < list.size(); ++n) {
            prefetch(data.fluid_gradient, list, n);
            const GradientRecord<D, Real>& j = data.fluid_gradient[static_cast<std::size_t>(list[n])];
            const Components<T, D> r = position.template to<Real>(j.x, c.unit);
            const T q = sqrt(dot<T, D>(r, r)) * c.inverse_h;
            const T volume_gradient = Kernel::gradient_factor(q) * (c.gradient_scale * j.volume);
            Components<T, D> u{};
            for (std::size_t k = 0; k < D; ++k) {
                u[k] = velocity[k] - j.u[k];
            }
            diffusion += density_diffusion(volume_gradient, T(s - j.s), r[D - 1], c.hydrostatic_gradient);
            for (std::size_t l = 0; l < D; ++l) {
                const T gradient_l = volume_gradient * r[l];
                for (std::size_t k = 0; k < D; ++k) {
                    gradient[k * D + l] -= u[k] * gradient_l;
                }
                for (std::size_t k = 0; k <= l; ++k) {
                    m_fluid[symmetric_index<D>(static_cast<int>(k), static_cast<int>(l))] -=
                        r[k] * gradient_l;
                }
            }
        }
        // The divergence of the pairs is minus the trace of the uncorrected gradient: sum V_j u.grad W.
        for (std::size_t k = 0; k < D; ++k) {
            divergence -= gradient[k * D + k];
        }

        if (data.fluid_wall != nullptr) {
            for (const std::int32_t slot_j : data.fluid_wall->of(cluster)) {
                const WallGradientRecord<D, Real>& j = data.wall_gradient[static_cast<std::size_t>(slot_j)];
                const Components<T, D> r = position.template to<Real>(j.x, c.unit);
                const T q = sqrt(dot<T, D>(r, r)) * c.inverse_h;
                const T volume_gradient = Kernel::gradient_factor(q) * (c.gradient_scale * j.volume);
                Components<T, D> u{};
                for (std::size_t k = 0; k < D; ++k) {
                    T sum = velocity[0] * j.projector[k * D];
                    for (std::size_t l = 1; l < D; ++l) {
                        sum += velocity[l] * j.projector[k * D + l];
                    }
                    u[k] = sum;
                }
                divergence += continuity<T, D>(volume_gradient, u, r);
                const T continued = volume_gradient * j.continuation;
                for (std::size_t l = 0; l < D; ++l) {
                    for (std::size_t k = 0; k <= l; ++k) {
                        const std::size_t kl = symmetric_index<D>(static_cast<int>(k), static_cast<int>(l));
                        m_continued[kl] -= continued * r[k] * r[l];
                        m_wall[kl] -= (volume_gradient - continued) * r[k] * r[l];
                    }
                }
            }
        }

        // The corrected gradient G M_fluid^-1 is exact for linear fields as long as M_fluid can be inverted.
        const T gradient_blend = c.correct_gradient
                                     ? smoothstep<T>(Real(0.1), Real(0.3), smallest_eigenvalue<T, D>(m_fluid))
                                     : T(0);
        const Components<T, D* D> gradient_matrix =
            pressure_correction<T, D>(m_fluid, Symmetric<T, D>{}, gradient_blend);

        add(m_fluid, m_continued);
        Symmetric<T, D> m_total = m_fluid;
        add(m_total, m_wall);
        const T regularity = smallest_eigenvalue<T, D>(m_total);
        const T pressure_blend = c.correct_pressure ? smoothstep<T>(Real(0.6), Real(0.9), regularity) : T(0);
        const Components<T, D* D> b = pressure_correction<T, D>(m_fluid, m_wall, pressure_blend);

        for (std::size_t k = 0; k < D; ++k) {
            for (std::size_t l = 0; l < D; ++l) {
                T sum = gradient[k * D] * gradient_matrix[l];
                for (std::size_t m = 1; m < D; ++m) {
                    sum += gradient[k * D + m] * gradient_matrix[m * D + l];
                }
                store_lanes(sum, &data.gradient.velocity_gradient[k * D + l][slot]);
                store_lanes(b[k * D + l], &data.gradient.correction[k * D + l][slot]);
            }
        }
        store_lanes(divergence, &data.gradient.density_rate[slot]);
        store_lanes(T(diffusion * c.diffusion), &data.gradient.diffusion[slot]);
        // The two-point viscosity is nu M_kl d2u/dx_k dx_l. Among disordered particles tr(M)/D falls below
        // one, and Taylor-Green vortices decay 1 to 2 % too slowly; this factor puts that right.
        T trace = m_total[0];
        for (int k = 1; k < D; ++k) {
            trace += m_total[symmetric_index<D>(k, k)];
        }
        store_lanes(T(Real(1) + pressure_blend * (Real(D) / trace - Real(1))),
                    &data.gradient.viscosity_factor[slot]);
        store_lanes(regularity, &data.gradient.regularity[slot]);
    }
}

template <int D, class Real, class Kernel, class Viscosity>
[[gnu::flatten]] void force_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end) {
    using T = Lanes<Real>;
    using std::experimental::sqrt;
    const PairConstants<D, Real> c = data.constants;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t slot = cluster * cluster_size;
        const ForceRecord<D, Real>* own = &data.fluid_force[slot];
        const LanePositions<D> position = gather_positions<D>(own);
        const Components<T, D> velocity = gather_velocities<D, Real>(own);
        const T viscosity_root = gather<Real>(own, [](const auto& r) { return r.viscosity_root; });
        Components<T, D * D> stress{};
        for (std::size_t k = 0; k < D * D; ++k) {
            stress[k] = gather<Real>(own, [k](const auto& r) { return r.stress[k]; });
        }
        const auto pair = [&](const ForceRecord<D, Real>& j, const Components<T, D * D>& stress_sum,
                              Components<T, D>& tensor, Components<T, D>& viscous) {
            const Components<T, D> r = position.template to<Real>(j.x, c.unit);
            const T r_squared = dot<T, D>(r, r);
            const T gradient = Kernel::gradient_factor(T(sqrt(r_squared) * c.inverse_h)) * c.gradient_scale;
            add(tensor, tensor_force<T, D>(gradient * j.weight, stress_sum, r));
            Components<T, D> u{};
            for (std::size_t k = 0; k < D; ++k) {
                u[k] = velocity[k] - j.u[k];
            }
            add(viscous, Viscosity::template force<T, D>(
                             gradient * j.volume, pair_viscosity_sum<T>(viscosity_root, T(j.viscosity_root)),
                             u, r, r_squared));
        };

        Components<T, D> tensor{};
        Components<T, D> viscous{};
        const auto list = data.fluid_fluid->of(cluster);
        for (std::size_t n = 0; n < list.size(); ++n) {
            prefetch(data.fluid_force, list, n);
            const ForceRecord<D, Real>& j = data.fluid_force[static_cast<std::size_t>(list[n])];
            Components<T, D * D> stress_sum{};
            for (std::size_t k = 0; k < D * D; ++k) {
                stress_sum[k] = stress[k] + j.stress[k];
            }
            pair(j, stress_sum, tensor, viscous);
        }

        Components<T, D> wall_tensor{};
        Components<T, D> wall_viscous{};
        if (data.fluid_wall != nullptr) {
            // (p_i + p_j) I, or (p_i + p_j) B_i where the wall continues the fluid.
            const T pressure = load_lanes(&data.fluid_pressure[slot]);
            Components<T, D * D> departure{};
            for (std::size_t k = 0; k < D * D; ++k) {
                departure[k] =
                    load_lanes(&data.gradient.correction[k][slot]) - (k % (D + 1) == 0 ? Real(1) : Real(0));
            }
            for (const std::int32_t slot_j : data.fluid_wall->of(cluster)) {
                const ForceRecord<D, Real>& j = data.wall_force[static_cast<std::size_t>(slot_j)];
                const T pressure_sum = pressure + j.stress[0];
                const T corrected = pressure_sum * j.continuation;
                Components<T, D * D> stress_sum{};
                for (std::size_t k = 0; k < D * D; ++k) {
                    stress_sum[k] = corrected * departure[k] + (k % (D + 1) == 0 ? pressure_sum : T(0));
                }
                pair(j, stress_sum, wall_tensor, wall_viscous);
            }
        }
        for (std::size_t k = 0; k < D; ++k) {
            store_lanes(T(tensor[k] + wall_tensor[k]), &data.force.tensor[k][slot]);
            store_lanes(T(viscous[k] + wall_viscous[k]), &data.force.viscous[k][slot]);
            store_lanes(T(wall_tensor[k] + wall_viscous[k]), &data.force.wall[k][slot]);
        }
    }
}

template <int D, class Real, class Kernel>
[[gnu::flatten]] void wall_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end) {
    using T = Lanes<Real>;
    using std::experimental::sqrt;
    const PairConstants<D, Real> c = data.constants;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t slot = cluster * cluster_size;
        const LanePositions<D> position = gather_positions<D>(&data.wall_force[slot]);
        T weight = T(0);
        T pressure = T(0);
        T density_rate = T(0);
        Components<T, D> offset{};
        Components<T, D> velocity{};
        for (const std::int32_t slot_j : data.wall_fluid->of(cluster)) {
            const ForceRecord<D, Real>& j = data.fluid_force[static_cast<std::size_t>(slot_j)];
            const Components<T, D> r = position.template to<Real>(j.x, c.unit);
            const T q = sqrt(dot<T, D>(r, r)) * c.inverse_h;
            const T w = Kernel::value(q);
            weight += w;
            pressure += w * data.fluid_pressure[static_cast<std::size_t>(slot_j)];
            Components<T, D> u{};
            for (std::size_t k = 0; k < D; ++k) {
                offset[k] += w * r[k];
                velocity[k] += w * j.u[k];
                u[k] = T(-j.u[k]);
            }
            density_rate +=
                continuity<T, D>(Kernel::gradient_factor(q) * (c.gradient_scale * j.volume), u, r);
        }
        store_lanes(weight, &data.wall.weight[slot]);
        store_lanes(pressure, &data.wall.pressure[slot]);
        store_lanes(density_rate, &data.wall.density_rate[slot]);
        for (std::size_t k = 0; k < D; ++k) {
            store_lanes(offset[k], &data.wall.offset[k][slot]);
            store_lanes(velocity[k], &data.wall.velocity[k][slot]);
        }
    }
}

template <int D, class Real, class Kernel>
[[gnu::flatten]] void filter_loop(PairData<D, Real>& data, std::size_t begin, std::size_t end) {
    using T = Lanes<Real>;
    using std::experimental::sqrt;
    const PairConstants<D, Real> c = data.constants;
    const Real kernel_scale = c.gradient_scale / (c.inverse_h * c.inverse_h);  // h^-D
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t slot = cluster * cluster_size;
        const GradientRecord<D, Real>* own = &data.fluid_gradient[slot];
        const LanePositions<D> position = gather_positions<D>(own);
        const Components<T, D> own_velocity = gather_velocities<D, Real>(own);
        T zeroth = T(0);
        T mass = T(0);
        Components<T, D> first{};
        Components<T, D> mass_first{};
        Components<T, D> velocity{};
        Symmetric<T, D> second{};
        for (const std::int32_t slot_j : data.fluid_fluid->of(cluster)) {
            const GradientRecord<D, Real>& j = data.fluid_gradient[static_cast<std::size_t>(slot_j)];
            const Components<T, D> r = position.template to<Real>(j.x, c.unit);
            const T w = Kernel::value(T(sqrt(dot<T, D>(r, r)) * c.inverse_h)) * (kernel_scale * j.volume);
            const T mass_weight = w * (Real(1) + j.s);
            zeroth += w;
            mass += mass_weight;
            for (std::size_t k = 0; k < D; ++k) {
                first[k] += w * r[k];
                mass_first[k] += mass_weight * r[k];
                velocity[k] += w * (j.u[k] - own_velocity[k]);
                for (std::size_t l = k; l < D; ++l) {
                    second[symmetric_index<D>(static_cast<int>(k), static_cast<int>(l))] += w * r[k] * r[l];
                }
            }
        }
        store_lanes(zeroth, &data.filter.zeroth[slot]);
        store_lanes(mass, &data.filter.mass[slot]);
        for (std::size_t k = 0; k < D; ++k) {
            store_lanes(first[k], &data.filter.first[k][slot]);
            store_lanes(mass_first[k], &data.filter.mass_first[k][slot]);
            store_lanes(velocity[k], &data.filter.velocity[k][slot]);
        }
        for (std::size_t k = 0; k < second.size(); ++k) {
            store_lanes(second[k], &data.filter.second[k][slot]);
        }
    }
}

template <int D, class Real, class Kernel>
PairLoops<D, Real> loops_of_kernel(ViscosityForm viscosity) {
    PairLoops<D, Real> loops{};
    loops.gradient = &gradient_loop<D, Real, Kernel>;
    loops.force = viscosity == ViscosityForm::morris ? &force_loop<D, Real, Kernel, MorrisViscosity>
                                                     : &force_loop<D, Real, Kernel, MonaghanGingoldViscosity>;
    loops.wall = &wall_loop<D, Real, Kernel>;
    loops.filter = &filter_loop<D, Real, Kernel>;
    return loops;
}

template <int D, class Real>
PairLoops<D, Real> loops(KernelKind kernel, ViscosityForm viscosity) {
    return visit_kernel<D>(
        kernel, [viscosity](auto chosen) { return loops_of_kernel<D, Real, decltype(chosen)>(viscosity); });
}

}  // namespace riffle::RIFFLE_ISA
