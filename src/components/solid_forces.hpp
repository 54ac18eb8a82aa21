#pragma once

#include <algorithm>
#include <vector>

#include "boundary/wall_motion.hpp"
#include "engine/component.hpp"
#include "engine/pass_order.hpp"

namespace riffle {

/// The forces of the water on each solid, in steps that keep the fields: the force pass again, with the walls
/// of one solid and no fluid.
template <int D, class Real>
class SolidForces final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    void begin_step(Flow& flow, double /*dt*/) override {
        if (flow.keep_fields && listed_ != flow.clock.list_builds) {
            listed_ = flow.clock.list_builds;
            list(flow);
        }
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        if (!flow.keep_fields) {
            return;
        }
        thread_local BlockWork<D, Real> work;
        if (work.slots.size() < task.sums.slots.size()) {
            work.slots.resize(task.sums.slots.size());
        }
        const std::vector<double>& mass = flow.particles.mass;
        for (std::size_t solid = 0; solid < lists_.size(); ++solid) {
            ForceOnSolid& sum = block_forces_[begin / block_clusters * lists_.size() + solid];
            sum = {};
            const NeighbourList& list = lists_[solid];
            const std::uint8_t* const masks = list.masks.data();
            if (std::all_of(masks + list.mask_begin[begin], masks + list.mask_begin[end],
                            [](std::uint8_t mask) { return mask == 0; })) {
                continue;
            }
            work.fluid_fluid = &no_list_;
            work.fluid_wall = &list;
            flow.loops.force(flow.data, begin, end, work);
            flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
                // What pushes the water one way pushes the solid the other.
                const double factor = -mass[i] * flow.force_factor(i);
                for (std::size_t k = 0; k < Flow::axes; ++k) {
                    const std::size_t axis = k == Flow::vertical ? 2 : k;
                    sum.pressure[axis] += factor * static_cast<double>(work.force.tensor[k][lane]);
                    sum.friction[axis] += factor * static_cast<double>(work.force.viscous[k][lane]);
                }
            });
        }
    }

    /// The sums over the blocks, in their order.
    void end_step(Flow& flow) override {
        if (!flow.keep_fields) {
            return;
        }
        flow.solid_forces.assign(lists_.size(), ForceOnSolid{});
        for (std::size_t i = 0; i < block_forces_.size(); ++i) {
            ForceOnSolid& sum = flow.solid_forces[i % lists_.size()];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sum.pressure[axis] += block_forces_[i].pressure[axis];
                sum.friction[axis] += block_forces_[i].friction[axis];
            }
        }
    }

  private:
    /// Lists of the walls of each solid alone, and room for the sums; once for each build of the lists.
    void list(const Flow& flow) {
        no_list_.run_begin.assign(flow.clusters.size() + 1, 0);
        no_list_.mask_begin.assign(flow.clusters.size() + 1, 0);
        no_list_.empty_slot = flow.fluid_fluid.empty_slot;
        lists_.assign(flow.c.solids.size(), flow.fluid_wall);
        for (std::size_t solid = 0; solid < lists_.size(); ++solid) {
            keep_solid(flow, first_solid + static_cast<std::int32_t>(solid), lists_[solid]);
        }
        block_forces_.assign(blocks_of(flow.clusters.size()) * lists_.size(), ForceOnSolid{});
    }

    /// Take all particles but those of a body out of a list of walls.
    static void keep_solid(const Flow& flow, std::int32_t body, NeighbourList& list) {
        const auto of_solid = [&](std::size_t slot) {
            const std::int32_t particle = flow.wall_clusters.particle_of(slot);
            return particle >= 0 && flow.walls.body[static_cast<std::size_t>(particle)] == body;
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

    std::vector<NeighbourList> lists_;        ///< of FlowOf::fluid_wall, the pairs with each solid
    NeighbourList no_list_;                   ///< without any neighbour, for as many clusters
    std::int64_t listed_ = -1;                ///< SimulationClock::list_builds of these lists
    std::vector<ForceOnSolid> block_forces_;  ///< by block and solid
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_solid_forces(FlowOf<D, Real>& flow) {
    return flow.c.solids.empty() ? nullptr : std::make_unique<SolidForces<D, Real>>();
}

}  // namespace riffle
