#pragma once

#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include "case/end_buffers.hpp"
#include "engine/component.hpp"
#include "engine/pair_setup.hpp"
#include "particles/lattice.hpp"
#include "roughness/bed_drag.hpp"
#include "roughness/covered_bed.hpp"
#include "roughness/log_law_friction.hpp"
#include "roughness/particle_bed_drag.hpp"
#include "roughness/side_wall_partition.hpp"

namespace riffle::inline components {

/// The drag of the bed, and that of the side walls in their layers, whose coefficient may follow from it.
template <int D, class Real>
class BedDragForce final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    BedDragForce(Flow& flow, std::unique_ptr<const BedDrag> drag) : drag_(std::move(drag)) {
        flow.inputs.drag = drag_ != nullptr;
        if (D == 3 && drag_ && drag_->varies_with_speed()) flow.inputs.acceleration = true;
        if (D == 3 && flow.c.has_side_wall_drag()) {
            flow.with_side_drag = true;
            if (flow.c.side_walls.drag_form == SideDragForm::thesis) {
                flow.clock.side_wall_drag_coefficient = printed_side_wall_coefficient(flow.c);
            } else if (flow.c.side_walls.drag_form == SideDragForm::log_law) {
                wall_friction_ = side_wall_friction(flow.c);
                layer_mass_ = mass_of_layers(flow.c);
            } else if (drag_) {
                wall_over_bed_ = side_wall_partition(flow.c).wall_over_bed;
            }
            if (side_drag_follows_flow()) {
                flow.inputs.sum_of_drags = true;
                set_side_drag(flow, measured(flow));
            }
        }
    }

    void begin_evaluation(Flow& flow, const Stage& /*stage*/) override {
        flow.inputs.side_drag = flow.clock.side_wall_drag_coefficient;
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        if (!drag_) return;
        // Few clusters reach into the roughness.
        const std::uint32_t reaching =
            flow.particle_loops.standing_below(flow.particle_data, drag_->top(), begin, end);
        task.particles.drag_clusters = reaching;
        const std::vector<double>& height = flow.particles.position[Flow::vertical];
        const auto block_first = static_cast<std::size_t>(flow.clusters.begin[begin]);
        const bool in_plan = drag_->varies_in_plan();
        for (std::uint32_t left = reaching; left != 0; left &= left - 1) {
            const std::size_t cluster = begin + static_cast<std::size_t>(std::countr_zero(left));
            const auto first = static_cast<std::size_t>(flow.clusters.begin[cluster]);
            const auto count = static_cast<std::size_t>(flow.clusters.count(cluster));
            double* const drag = &task.particles.drag[first - block_first];
            if (in_plan) {
                for (std::size_t n = 0; n < count; ++n) drag[n] = coefficient_at_rest(flow, first + n);
            } else {
                drag_->coefficients({&height[first], count}, {drag, count});
            }
            if (drag_->varies_with_speed()) {
                follow_speed(flow, task, first, count, first - block_first, (cluster - begin) * cluster_size);
            }
        }
    }

    void end_evaluation(Flow& flow) override {
        if (!side_drag_follows_flow()) return;
        if (!flow.motion_summed) {
            set_side_drag(flow, measured(flow));
            return;
        }
        Sums sums{};
        for (const AdvanceResult<D>& block : flow.block_advance) {
            sums[0] += block.bed_drag;
            sums[1] += block.side_layer;
        }
        set_side_drag(flow, sums);
    }

  private:
    using Sums = std::array<double, 2>;  ///< of m beta u|u| of the bed, of m u|u| in the side walls' layers

    [[nodiscard]] bool side_drag_follows_flow() const { return wall_over_bed_ > 0.0 || wall_friction_; }

    /// Of the water of the case in the layers of its side walls, kg.
    static double mass_of_layers(const Case& c) {
        const double layers = c.channel.sides == Sides::half ? 1.0 : 2.0;
        return layers * c.fluid.density * c.side_layer() * c.total_depth() * c.channel.length;
    }

    /// Of the bed at a particle, as if the water were at rest.
    [[nodiscard]] double coefficient_at_rest(const Flow& flow, std::size_t particle) const {
        const auto& position = flow.particles.position;
        return drag_->coefficient_at(position[0][particle], across_of<D>(position, particle),
                                     position[Flow::vertical][particle]);
    }

    /// At its speed.
    [[nodiscard]] double coefficient(const Flow& flow, std::size_t particle) const {
        if (!drag_) return 0.0;
        double beta = coefficient_at_rest(flow, particle);
        if (drag_->varies_with_speed()) {
            const auto& velocity = flow.particles.velocity;
            beta *= speed_factor(flow, particle,
                                 std::hypot(velocity[0][particle], across_of<D>(velocity, particle)));
        }
        return beta;
    }

    [[nodiscard]] double speed_factor(const Flow& flow, std::size_t particle, double speed) const {
        const auto& position = flow.particles.position;
        return drag_->speed_factor_at(position[0][particle], across_of<D>(position, particle),
                                      position[Flow::vertical][particle], speed);
    }

    /// The drag at the speed of the water, of particles whose work and lanes begin at places of the block. In
    /// three dimensions the friction is beta |u| u, of which the implicit step has beta u_k |u_k|.
    void follow_speed(const Flow& flow, Task& task, std::size_t first, std::size_t count, std::size_t work,
                      std::size_t lane) const {
        const auto& velocity = flow.particles.velocity;
        for (std::size_t n = 0; n < count; ++n) {
            double& beta = task.particles.drag[work + n];
            const double u = velocity[0][first + n];
            const double v = across_of<D>(velocity, first + n);
            const double speed = std::hypot(u, v);
            beta *= speed_factor(flow, first + n, speed);
            if constexpr (D == 3) {
                task.particles.acceleration[0][lane + n] -= beta * (speed - std::abs(u)) * u;
                task.particles.acceleration[1][lane + n] -= beta * (speed - std::abs(v)) * v;
            }
        }
    }

    [[nodiscard]] Sums measured(const Flow& flow) const {
        const Particles<D>& particles = flow.particles;
        return reduce_blocks(
            particles.size(), std::size_t{1024}, Sums{},
            [&](std::size_t begin, std::size_t end) {
                Sums part{};
                for (std::size_t i = begin; i < end; ++i) {
                    const double u = particles.velocity[0][i];
                    const double square = particles.mass[i] * u * std::abs(u);
                    const double y = particles.position[1][i];
                    if (!in_channel(flow.c, particles.position[0][i])) continue;
                    part[0] += coefficient(flow, i) * square;
                    part[1] += flow.particle_data.in_side_layer(particles.position[0][i], y) ? square : 0.0;
                }
                return part;
            },
            [](const Sums& a, const Sums& b) {
                return Sums{a[0] + b[0], a[1] + b[1]};
            });
    }

    /// By the log law from the mean u|u| of the layers. Else each side wall takes wall_over_bed times the
    /// drag of the bed of the whole width: of all that is simulated between two walls, of twice that where
    /// one half is simulated. Either way the coefficient of its layer is 2 wall_over_bed sum(m beta u|u|) /
    /// sum over all layers (m u|u|).
    void set_side_drag(Flow& flow, const Sums& sums) const {
        if (wall_friction_) {
            flow.clock.side_wall_drag_coefficient = wall_friction_->coefficient(sums[1] / layer_mass_);
            return;
        }
        // Of water at rest nothing follows; the last coefficient stays.
        if (sums[0] >= 0.0 && sums[1] > 0.0) {
            flow.clock.side_wall_drag_coefficient = 2.0 * wall_over_bed_ * sums[0] / sums[1];
        }
    }

    std::unique_ptr<const BedDrag> drag_;
    double wall_over_bed_ = 0.0;  ///< force on each side wall over that on the bed; 0: not by the bed
    std::optional<LogLawFriction> wall_friction_;  ///< of side walls by the log law
    double layer_mass_ = 0.0;                      ///< of the water in their layers, kg
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_bed_drag_force(FlowOf<D, Real>& flow) {
    auto drag = drag_beside_solids(flow.c, make_particle_bed_drag(flow.c, lattice_of(flow.c).dz));
    return drag || (D == 3 && flow.c.has_side_wall_drag())
               ? std::make_unique<BedDragForce<D, Real>>(flow, std::move(drag))
               : nullptr;
}

}  // namespace riffle::inline components
