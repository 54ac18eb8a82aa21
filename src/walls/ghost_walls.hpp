#pragma once

#include <optional>

#include "engine/pair_setup.hpp"
#include "walls/ghost_nodes.hpp"
#include "walls/wall_treatment.hpp"

namespace riffle::inline walls {

/// Wall particles that carry the density found at their mirror images in the water (English et al. 2022).
template <int D, class Real>
class GhostWalls final : public WallTreatment<D, Real> {
  public:
    using typename WallTreatment<D, Real>::Flow;
    using typename WallTreatment<D, Real>::Task;
    using WallTreatment<D, Real>::WallTreatment;

    void walls_placed(Flow& flow) override {
        nodes_.emplace(flow.c, flow.scheme, flow.domain, flow.walls, flow.column_width);
    }
    void lists_built(Flow& flow, double reach) override { nodes_->build_list(flow.clusters, reach); }
    [[nodiscard]] bool looks_at_all_water() const override { return true; }
    void look_at_water(Flow& flow) override {
        nodes_->interpolate(flow.data, flow.clusters, flow.particles.density_deviation);
    }
    void update(Flow& flow, Task& /*task*/, const Stage& /*stage*/, std::size_t begin,
                std::size_t end) override {
        this->for_walls(flow, begin, end, [&](std::size_t slot, std::size_t i) {
            const GhostValue<D>& ghost = nodes_->of(i);
            // Without water near its image a particle is as dry as one a spacing above the surface.
            const double dry = -flow.scheme.normal_gravity * flow.c.numerics.spacing;
            flow.walls.density_deviation[i] =
                ghost.found ? ghost.deviation : flow.scheme.state.deviation(dry);
            this->wet(flow, slot, i, flow.scheme.state.pressure(flow.walls.density_deviation[i]));
            auto& record = flow.data.wall_force[slot];
            record.pressure =
                ghost.found
                    ? static_cast<Real>(pair_pressure(flow.c, flow.scheme, flow.walls.density_deviation[i]))
                    : Real(0);
            record.u = {};
            if (this->action().rests_at(flow.walls, i)) {
                // The wall stands halfway between the particle and its image; a lid may move along the
                // channel.
                const double lid =
                    flow.walls.normal[Flow::vertical][i] < 0.0 ? flow.c.channel.lid_velocity : 0.0;
                for (std::size_t k = 0; k < Flow::axes; ++k) {
                    record.u[k] = static_cast<Real>((k == 0 ? 2.0 * lid : 0.0) - ghost.velocity[k]);
                }
            }
        });
    }
    [[nodiscard]] std::size_t bytes() const override { return nodes_ ? nodes_->bytes() : 0; }

  private:
    std::optional<GhostNodes<D>> nodes_;
};

}  // namespace riffle::inline walls
