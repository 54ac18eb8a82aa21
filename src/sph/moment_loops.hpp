#pragma once

// Sums that the kernel itself weighs: what walls extrapolate from the water, and moments of the water.
// Compiled once per instruction set, like pair_loops_impl.hpp.

#include "sph/cluster_turns.hpp"
#include "sph/kernel.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

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
        for (std::size_t k = 0; k < second.size(); ++k) store(second[k], c.h * c.h, work.filter.second[k]);
    }
}

}  // namespace riffle::inline sph::RIFFLE_ISA
