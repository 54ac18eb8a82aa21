#pragma once

// The force pass. Compiled once per instruction set, like pair_loops_impl.hpp.

#include "sph/cluster_turns.hpp"
#include "sph/kernel.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

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
                    if constexpr (further) pressure_sum -= form.non_conservative * pressure;
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

}  // namespace riffle::inline sph::RIFFLE_ISA
