#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "boundary/round_body.hpp"
#include "boundary/solid_surface.hpp"
#include "boundary/surface_pieces.hpp"
#include "boundary/wall_motion.hpp"
#include "case/end_buffers.hpp"
#include "case/solid_motion.hpp"
#include "case/solid_volume.hpp"
#include "components/solid_corners.hpp"
#include "components/solid_feet.hpp"
#include "engine/component.hpp"
#include "engine/pass_order.hpp"

namespace riffle::inline components {

/// The forces of the water on each solid and their moments, in steps that keep the fields: the force pass
/// again, with the walls of one solid and no fluid, and with those behind its foot on a plane wall. Of free
/// bodies in all steps: they move by them.
template <int D, class Real>
class SolidForces final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit SolidForces(const Flow& flow)
        : surfaces_(flow.c),
          lists_(flow.c.solids.size()),
          corners_(flow.c.solids.size(), SolidCorners<D, Real>(flow.c)),
          feet_(flow.c.solids.size()),
          listed_(flow.c.solids.size(), -1) {
        const Case& c = flow.c;
        for (const Solid& solid : c.solids) {
            points_.push_back(moment_point(c, solid));
            volumes_.push_back(solid.surface == SolidSurface::no_slip && turns(c, solid)
                                   ? solid_volume(c, solid).volume
                                   : 0.0);
            free_.push_back(solid.is_free());
            round_.push_back(solid.is_free() ? round_body(solid) : std::nullopt);
        }
        if (flow.particle_data.reference_pressure.acts()) {
            for (std::size_t solid = 0; solid < lists_.size(); ++solid) {
                reference_loads_.push_back(reference_load(flow, solid));
            }
        }
    }

    void begin_step(Flow& flow, double /*dt*/) override {
        for (std::size_t solid = 0; solid < lists_.size(); ++solid) {
            if (wanted(flow, solid) && listed_[solid] != flow.clock.list_builds) list(flow, solid);
        }
        if (flow.keeps_solid_forces()) block_forces_.resize(blocks_of(flow.clusters.size()) * lists_.size());
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        if (!flow.keeps_solid_forces()) return;
        thread_local BlockWork<D, Real> work;
        if (work.slots.size() < task.sums.slots.size()) work.slots.resize(task.sums.slots.size());
        for (std::size_t solid = 0; solid < lists_.size(); ++solid) {
            ForceOnSolid& sum = block_forces_[begin / block_clusters * lists_.size() + solid];
            sum = {};
            if (!wanted(flow, solid)) continue;
            work.fluid_fluid = &no_list_;
            add_pairs(flow, work, lists_[solid], solid, begin, end, [&](std::size_t first, std::size_t last) {
                add_clusters(
                    flow, work.force, solid, first, last, [](std::size_t) { return whole; }, sum);
            });
            const SolidCorners<D, Real>& corners = corners_[solid];
            for (const auto& part : corners.parts()) {
                add_pairs(flow, work, part.list, solid, begin, end, [&](std::size_t first, std::size_t last) {
                    add_clusters(
                        flow, work.force, solid, first, last,
                        [&](std::size_t slot) { return corners.share(part, slot); }, sum);
                });
            }
        }
    }

    /// The sums over the blocks, in their order.
    void end_evaluation(Flow& flow) override {
        if (!flow.keeps_solid_forces()) return;
        flow.solid_forces.assign(lists_.size(), ForceOnSolid{});
        for (std::size_t i = 0; i < block_forces_.size(); ++i) {
            flow.solid_forces[i % lists_.size()] += block_forces_[i];
        }
        for (std::size_t solid = 0; solid < reference_loads_.size(); ++solid) {
            flow.solid_forces[solid] += reference_loads_[solid];
        }
        for (std::size_t solid = 0; solid < lists_.size(); ++solid) {
            if (!wanted(flow, solid)) continue;
            ForceOnSolid& force = flow.solid_forces[solid];
            if (volumes_[solid] > 0.0) add_spin(flow, solid, force);
            if (round_[solid]) round_[solid]->clear_moment(force, points_[solid], body_of(flow, solid));
        }
    }

    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = block_forces_.capacity() * sizeof(ForceOnSolid);
        for (std::size_t solid = 0; solid < lists_.size(); ++solid) {
            sum += lists_[solid].bytes() + feet_[solid].bytes() + corners_[solid].bytes();
        }
        return sum;
    }

  private:
    using Share = typename SolidCorners<D, Real>::Share;
    static constexpr Share whole{{1.0, 1.0, 1.0}, true};

    [[nodiscard]] bool wanted(const Flow& flow, std::size_t solid) const {
        return flow.keep_fields || free_[solid];
    }

    /// Where a solid is in the evaluation in progress.
    static const BodyState& body_of(const Flow& flow, std::size_t solid) {
        static const BodyState rest;
        return flow.bodies.empty() ? rest : flow.bodies[first_solid + solid];
    }

    /// The force pass with one list of wall particles, then f(first, last) for runs of clusters that have
    /// pairs with the solid.
    template <class F>
    void add_pairs(Flow& flow, BlockWork<D, Real>& work, const NeighbourList& list, std::size_t solid,
                   std::size_t begin, std::size_t end, const F& f) {
        work.fluid_wall = &list;
        for (std::size_t first = begin; first < end; ++first) {
            std::size_t last = first;
            while (last < end && feet_[solid].has(last)) ++last;
            if (last > first) {
                flow.loops.force(flow.data, first, last, work);
                f(first, last);
                first = last;
            }
        }
    }

    /// What the reference pressure, which no pair carries, presses a solid with.
    [[nodiscard]] ForceOnSolid reference_load(const Flow& flow, std::size_t solid) const {
        ForceOnSolid load;
        for (const SurfacePiece& piece : surface_pieces(flow.c, solid, 0.5 * flow.scheme.spacing)) {
            const double pressure =
                flow.scheme.density * flow.particle_data.reference_pressure.value(piece.place[2]);
            Vec<3> arm{};
            Vec<3> force{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                arm[axis] = piece.place[axis] - points_[solid][axis];
                force[axis] = -pressure * piece.area[axis];
                load.pressure[axis] += force[axis];
            }
            const Vec<3> moment = cross(arm, force);
            for (std::size_t axis = 0; axis < 3; ++axis) load.pressure_moment[axis] += moment[axis];
        }
        return load;
    }

    /// The list of the walls of one solid alone, once for each build of the lists.
    void list(const Flow& flow, std::size_t solid) {
        listed_[solid] = flow.clock.list_builds;
        no_list_.run_begin.assign(flow.clusters.size() + 1, 0);
        no_list_.mask_begin.assign(flow.clusters.size() + 1, 0);
        no_list_.empty_slot = flow.fluid_fluid.empty_slot;
        lists_[solid] = flow.fluid_wall;
        keep_solid(flow, first_solid + static_cast<std::int32_t>(solid), lists_[solid]);
        feet_[solid].find(flow, surfaces_, solid, flow.bodies_listed()[first_solid + solid], lists_[solid]);
        if (flow.c.solids[solid].rests()) {
            corners_[solid].find(flow, surfaces_, solid,
                                 [&](std::size_t cluster) { return feet_[solid].has(cluster); });
        }
    }

    /// Morris' friction of a pair goes by the difference of the velocities, and so feels the turning of water
    /// that turns with the body as one stiff piece, where no friction is: over a whole surface the moment
    /// integral of r x (mu n x omega) = -2 mu V omega, which is taken off; of the wet share of the body.
    void add_spin(const Flow& flow, std::size_t solid, ForceOnSolid& force) const {
        double wet = 0.0;
        double all = 0.0;
        for (std::size_t slot = 0; slot < flow.wall_clusters.slots(); ++slot) {
            const std::int32_t particle = flow.wall_clusters.particle_of(slot);
            if (particle >= 0 && flow.walls.body[static_cast<std::size_t>(particle)] ==
                                     first_solid + static_cast<std::int32_t>(solid)) {
                wet += static_cast<double>(flow.data.wall_force[slot].viscous_weight);
                all += flow.walls.volume[static_cast<std::size_t>(particle)];
            }
        }
        const double viscosity = flow.scheme.density * flow.scheme.viscosity;
        const double factor = all > 0.0 ? -2.0 * viscosity * volumes_[solid] * wet / all : 0.0;
        const Vec<3>& spin = flow.bodies[first_solid + solid].angular_velocity;
        for (std::size_t axis = 0; axis < 3; ++axis) force.friction_moment[axis] += factor * spin[axis];
    }

    /// The sums of clusters that have pairs with a solid, of each particle the share of the slot.
    template <class ShareOfSlot>
    void add_clusters(const Flow& flow, const ForceResult<D, Real>& force, std::size_t solid,
                      std::size_t begin, std::size_t end, const ShareOfSlot& share_of,
                      ForceOnSolid& sum) const {
        const BodyState& body = body_of(flow, solid);
        const auto add = [](std::array<double, 3>& part, const Vec<3>& v) {
            for (std::size_t axis = 0; axis < 3; ++axis) part[axis] += v[axis];
        };
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const Share share = share_of(begin * cluster_size + lane);
            // Beyond open ends a sill that carries the water through has no place in the account.
            if (!share.any() || !in_channel(flow.c, flow.particles.position[0][i])) return;
            // What pushes the water one way pushes the solid the other, and through grains it presses as much
            // as in open water.
            const double water = flow.porous.empty() ? 1.0 : flow.porous_at[i].porosity;
            const double factor = -flow.particles.mass[i] * flow.force_factor(i) / water;
            Vec<D> pressure{};
            Vec<D> friction{};
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                pressure[k] = factor * static_cast<double>(force.tensor[k][lane]);
                friction[k] = factor * static_cast<double>(force.viscous[k][lane]);
            }
            Vec<3> push = in_space_of<D>(pressure);
            for (std::size_t axis = 0; axis < 3; ++axis) push[axis] *= share.along[axis];
            add(sum.pressure, push);
            const std::size_t cluster = begin + lane / cluster_size;
            const Vec<3> place = body.place_at_start(
                place_beside<D>(flow.domain, body, vector_of(flow.particles.position, i)));
            const Vec<3> arm =
                body.turned(feet_[solid].arm(surfaces_, cluster, lane % cluster_size, place, points_[solid]));
            add(sum.pressure_moment, cross(arm, push));
            if (!share.rubs) return;
            add(sum.friction, in_space_of<D>(friction));
            add(sum.friction_moment, cross(arm, in_space_of<D>(friction)));
        });
    }

    /// Take all particles but those of a body out of a list of walls.
    static void keep_solid(const Flow& flow, std::int32_t body, NeighbourList& list) {
        const auto of_solid = [&](std::size_t slot) {
            const std::int32_t particle = flow.wall_clusters.particle_of(slot);
            return particle >= 0 && flow.walls.body[static_cast<std::size_t>(particle)] == body;
        };
        for (std::size_t cluster = 0; cluster < list.size(); ++cluster) {
            for_listed_slots(list, cluster, [&](std::size_t mask, std::size_t slot) {
                if (of_solid(slot)) return;
                list.masks[mask] = static_cast<std::uint8_t>(list.masks[mask] & ~(1U << slot % cluster_size));
            });
        }
    }

    SolidSurfaces surfaces_;
    std::vector<Vec<3>> points_;   ///< of each solid, the one that its moments are about, at t = 0
    std::vector<double> volumes_;  ///< of those that turn and hold the water, m3; else 0
    std::vector<bool> free_;
    /// Of free bodies alone: beside a wall that turns the pressure of the pairs takes a part of the friction.
    std::vector<std::optional<RoundBody>> round_;
    std::vector<NeighbourList> lists_;            ///< of FlowOf::fluid_wall, the pairs with each solid
    std::vector<SolidCorners<D, Real>> corners_;  ///< of solids at rest
    NeighbourList no_list_;                       ///< without any neighbour, for as many clusters
    std::vector<SolidFeet<D, Real>> feet_;
    std::vector<std::int64_t> listed_;           ///< SimulationClock::list_builds of each list
    std::vector<ForceOnSolid> block_forces_;     ///< by block and solid
    std::vector<ForceOnSolid> reference_loads_;  ///< by solid; empty without a reference pressure
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_solid_forces(FlowOf<D, Real>& flow) {
    return flow.c.solids.empty() ? nullptr : std::make_unique<SolidForces<D, Real>>(flow);
}

}  // namespace riffle::inline components
