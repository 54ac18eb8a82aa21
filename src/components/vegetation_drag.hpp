#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "engine/component.hpp"
#include "particles/lattice.hpp"
#include "roughness/vegetation.hpp"

namespace riffle::inline components {

/// The drag of stems on the water between them, against its velocity. Of a particle that the top or an edge
/// of a patch cuts acts the share within, so that the force of a layered flow does not depend on where its
/// rows stand. With x = dt beta |u| the deceleration is beta |u| u / sqrt(1 + x^2): that of the explicit step
/// to the second order of x, and never more than what brings the water to rest within the step.
template <int D, class Real>
class VegetationDrag final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    VegetationDrag(Flow& flow, std::vector<VegetationPatch> patches)
        : patches_(std::move(patches)), row_(lattice_of(flow.c).dz), width_(flow.scheme.spacing) {
        flow.inputs.acceleration = true;
        flow.with_vegetation = true;
    }

    void begin_step(Flow& /*flow*/, double dt) override { step_ = dt; }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const auto& velocity = flow.particles.velocity;
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            double squared = 0.0;
            for (std::size_t k = 0; k < Flow::axes; ++k) squared += velocity[k][i] * velocity[k][i];
            const double speed = std::sqrt(squared);
            double beta = 0.0;
            for (const VegetationPatch& patch : patches_) {
                const double share = share_in(patch, flow, i);
                if (share > 0.0) beta += share * patch.drag().coefficient(speed);
            }
            const double rate = beta * speed;
            const double limited = rate / std::sqrt(1.0 + step_ * step_ * rate * rate);
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                const double acceleration = -limited * velocity[k][i];
                task.vegetation_acceleration[k][lane] = acceleration;
                task.particles.acceleration[k][lane] += acceleration;
            }
        });
    }

  private:
    [[nodiscard]] double share_in(const VegetationPatch& patch, const Flow& flow, std::size_t i) const {
        const auto& position = flow.particles.position;
        const double share = patch.share_in_plan(position[0][i], position[1][i], width_);
        if (share <= 0.0) return 0.0;
        const double over_feet =
            position[Flow::vertical][i] - patch.foot(position[0][i], across_of<D>(position, i));
        return share * patch.share_below_top(over_feet, row_);
    }

    std::vector<VegetationPatch> patches_;
    double row_;    ///< height of the rows, m
    double width_;  ///< of the particles, m
    double step_ = 0.0;
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_vegetation_drag(FlowOf<D, Real>& flow) {
    return flow.c.vegetation.empty()
               ? nullptr
               : std::make_unique<VegetationDrag<D, Real>>(flow, vegetation_patches(flow.c));
}

}  // namespace riffle::inline components
