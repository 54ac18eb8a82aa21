#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "case/end_buffers.hpp"
#include "engine/component.hpp"
#include "engine/particle_fault.hpp"
#include "engine/pass_order.hpp"

namespace riffle::inline components {

/// The force of the reference pressure (docs/theory.md, section 5): what the pairs do not carry of the
/// hydrostatic pressure holds the water up as a function of its height alone.
template <int D, class Real>
class ReferencePressureForce final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit ReferencePressureForce(Flow& flow) : reference_(flow.particle_data.reference_pressure) {
        flow.inputs.acceleration = true;
    }

    void begin_evaluation(Flow& flow, const Stage& /*stage*/) override {
        bare_.assign(flow.block_advance.size(), none);
    }

    /// The pairs know nothing of a reference pressure beyond a surface, and what stands there would be
    /// pressed as if there were water above it. Beyond open ends the water ends somewhere, and its motion is
    /// given.
    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const double lowest = lowest_at_surface(flow);
        std::size_t& bare = bare_[begin / block_clusters];
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            if (flow.particles.position[Flow::vertical][i] < lowest &&
                in_channel(flow.c, flow.particles.position[0][i]) &&
                task.sums.gradient.regularity[lane] < Real(surface_regularity)) {
                bare = std::min(bare, i);
            }
        });
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const double up =
                reference_.slope(flow.particles.position[Flow::vertical][i]) * flow.force_factor(i);
            task.reference_acceleration[lane] = up;
            task.particles.acceleration[Flow::vertical][lane] += up;
        });
    }

    /// Error where the surface has come below the level from which on the reference pressure acts.
    void end_evaluation(Flow& flow) override {
        const std::size_t bare = *std::min_element(bare_.begin(), bare_.end());
        if (bare != none) throw ParticleFault(bare, fallen(flow, bare));
    }

    [[nodiscard]] std::size_t bytes() const override { return bare_.capacity() * sizeof(std::size_t); }

  private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    /// Half of what surrounds a particle in the water: that of one at a flat surface.
    static constexpr double surface_regularity = 0.5;

    /// A particle at the surface stands half a spacing below it.
    [[nodiscard]] double lowest_at_surface(const Flow& flow) const {
        return reference_.level - 0.5 * flow.scheme.spacing;
    }

    std::string fallen(const Flow& flow, std::size_t i) const {
        const Particles<D>& p = flow.particles;
        return fmt::format(
            "the water's surface has come below {:.6g} m, where the reference pressure begins: particle {} at x = {:.6g} m{}, z = {:.6g} m stands at it at t = {:.6g} s. "
            "Take a larger [numerics] reference_depth_ratio (it is {:.3g}), or reference_pressure = \"none\"",
            reference_.level, p.id[i], p.position[0][i],
            D == 3 ? fmt::format(", y = {:.6g} m", p.position[1][i]) : "", p.position[Flow::vertical][i],
            flow.clock.time, flow.c.numerics.reference_depth_ratio);
    }

    HydrostaticReference reference_;
    std::vector<std::size_t> bare_;  ///< of each block, its first particle at a surface so low
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_reference_pressure_force(FlowOf<D, Real>& flow) {
    return flow.particle_data.reference_pressure.acts()
               ? std::make_unique<ReferencePressureForce<D, Real>>(flow)
               : nullptr;
}

}  // namespace riffle::inline components
