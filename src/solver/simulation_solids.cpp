// The forces of the water on each solid: the force pass again, with the walls of one solid and no fluid.

#include <algorithm>

#include "solver/pair_setup.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

template <int D, class Real>
void SimulationOf<D, Real>::list_solids() {
    if (case_.solids.empty() || solids_listed_ == clock_.list_builds) {
        return;
    }
    solids_listed_ = clock_.list_builds;
    no_list_.run_begin.assign(clusters_.size() + 1, 0);
    no_list_.mask_begin.assign(clusters_.size() + 1, 0);
    no_list_.empty_slot = fluid_fluid_.empty_slot;
    solid_lists_.assign(case_.solids.size(), fluid_wall_);
    for (std::size_t solid = 0; solid < solid_lists_.size(); ++solid) {
        NeighbourList& list = solid_lists_[solid];
        const std::int32_t body = first_solid + static_cast<std::int32_t>(solid);
        const auto of_solid = [&](std::size_t slot) {
            const std::int32_t particle = wall_clusters_.particle_of(slot);
            return particle >= 0 && walls_.body[static_cast<std::size_t>(particle)] == body;
        };
        for (std::size_t cluster = 0; cluster < list.size(); ++cluster) {
            std::size_t mask = list.mask_begin[cluster];
            for (std::size_t run = list.run_begin[cluster]; run < list.run_begin[cluster + 1]; ++run) {
                const std::size_t first = list.runs[run].first;
                const std::size_t count = list.runs[run].count;
                for (std::size_t wall = first; wall < first + count; ++wall, ++mask) {
                    for (std::size_t lane = 0; lane < cluster_size; ++lane) {
                        if (!of_solid(wall * cluster_size + lane)) {
                            list.masks[mask] = static_cast<std::uint8_t>(list.masks[mask] & ~(1U << lane));
                        }
                    }
                }
            }
        }
    }
    block_solid_forces_.assign(blocks_of(clusters_.size()) * solid_lists_.size(), ForceOnSolid{});
}

template <int D, class Real>
void SimulationOf<D, Real>::sum_solid_forces(Task& task, std::size_t begin, std::size_t end) {
    const std::size_t block = begin / block_clusters;
    const bool corrected = weighs_by_volume(case_);
    if (task.solid.slots.size() < task.sums.slots.size()) {
        task.solid.slots.resize(task.sums.slots.size());
    }
    for (std::size_t solid = 0; solid < solid_lists_.size(); ++solid) {
        ForceOnSolid& sum = block_solid_forces_[block * solid_lists_.size() + solid];
        sum = {};
        const NeighbourList& list = solid_lists_[solid];
        const auto any = [&](std::size_t cluster) {
            const auto from = list.masks.begin() + list.mask_begin[cluster];
            return std::any_of(from, list.masks.begin() + list.mask_begin[cluster + 1],
                               [](std::uint8_t mask) { return mask != 0; });
        };
        bool near = false;
        for (std::size_t cluster = begin; cluster < end && !near; ++cluster) {
            near = any(cluster);
        }
        if (!near) {
            continue;
        }
        task.solid.fluid_fluid = &no_list_;
        task.solid.fluid_wall = &list;
        loops_.force(data_, begin, end, task.solid);
        for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t first_lane) {
            for (std::size_t i = first; i < last; ++i) {
                const std::size_t lane = first_lane + (i - first);
                // What pushes the water one way pushes the solid the other.
                const double factor =
                    -particles_.mass[i] * (corrected ? 1.0 / (1.0 + particles_.density_deviation[i]) : 1.0);
                for (std::size_t k = 0; k < axes; ++k) {
                    const std::size_t axis = k == vertical ? 2 : k;
                    sum.pressure[axis] += factor * static_cast<double>(task.solid.force.tensor[k][lane]);
                    sum.friction[axis] += factor * static_cast<double>(task.solid.force.viscous[k][lane]);
                }
            }
        });
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::gather_solid_forces() {
    solid_forces_.assign(solid_lists_.size(), ForceOnSolid{});
    for (std::size_t i = 0; i < block_solid_forces_.size(); ++i) {
        ForceOnSolid& sum = solid_forces_[i % solid_lists_.size()];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sum.pressure[axis] += block_solid_forces_[i].pressure[axis];
            sum.friction[axis] += block_solid_forces_[i].friction[axis];
        }
    }
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle
