#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/component.hpp"
#include "sph/crowding.hpp"
#include "sph/kernel.hpp"

namespace riffle::inline components {

/// Each so many steps: raise the density of crowded particles, by the water around them, or by the walls as
/// well.
template <int D, class Real>
class Crowds final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    Crowds(bool counts_walls, int interval) : counts_walls_(counts_walls), interval_(interval) {}

    [[nodiscard]] bool looks_at_walls(const Flow& flow) const override {
        return counts_walls_ && looks_now(flow);
    }
    void begin_step(Flow& flow, double dt) override {
        if (!looks_now(flow)) return;
        const Scheme& scheme = flow.scheme;
        const double turns = interval_ * dt * scheme.state.sound_speed / scheme.smoothing_length;
        if (counts_walls_) sum_walls(flow);
        flow.for_moments([&](const FilterResult<D, Real>& sums, std::size_t particle, std::size_t lane) {
            const auto water = static_cast<double>(sums.zeroth[lane]);
            const double rate =
                counts_walls_ ? crowding_rate_with_walls(water + walls_[particle]) : crowding_rate(water);
            flow.particles.density_deviation[particle] += turns * rate;
        });
        flow.repack();
    }

  private:
    [[nodiscard]] bool looks_now(const Flow& flow) const { return flow.clock.steps % interval_ == 0; }

    /// Sum of V W over the particles of the walls around each particle, by Wendland's C2 kernel whatever that
    /// of the scheme: in full support all give 1.
    void sum_walls(Flow& flow) {
        walls_.assign(flow.particles.size(), 0.0);
        if (flow.walls.size() == 0) return;  // walls that repel have no particles
        flow.for_blocks([&](Task& task, std::size_t begin, std::size_t end) {
            std::int32_t* const slots = task.sums.slots.data();
            for (std::size_t cluster = begin; cluster < end; ++cluster) {
                const std::size_t count =
                    flow.fluid_wall.run_begin[cluster] == flow.fluid_wall.run_begin[cluster + 1]
                        ? 0
                        : flow.fluid_wall.spell(cluster, slots);
                flow.for_particles(cluster, cluster + 1, [&](std::size_t i, std::size_t) {
                    for (std::size_t n = 0; n < count; ++n) {
                        walls_[i] += share(flow, i, static_cast<std::size_t>(slots[n]));
                    }
                });
            }
        });
    }

    /// V W of the wall particle in a slot at a particle.
    static double share(const Flow& flow, std::size_t i, std::size_t slot) {
        const std::int32_t particle = flow.wall_clusters.particle_of(slot);
        if (particle < 0) return 0.0;
        const auto j = static_cast<std::size_t>(particle);
        const double h = flow.scheme.smoothing_length;
        double squared = 0.0;
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            double apart = std::abs(flow.particles.position[k][i] - flow.walls.position[k][j]);
            if (flow.domain.periodic[k]) {
                apart = std::min(apart, flow.domain.extent(static_cast<int>(k)) - apart);
            }
            squared += apart * apart;
        }
        const double q = std::sqrt(squared) / h;
        return q < 2.0 ? flow.walls.volume[j] * WendlandC2<D>::value(q) / std::pow(h, D) : 0.0;
    }

    bool counts_walls_;
    int interval_;               ///< steps from one look to the next
    std::vector<double> walls_;  ///< of each particle, sum of V W over the walls
};

/// Whether a solid that moves pushes slow water into the edges between walls in space.
template <int D, class Real>
[[nodiscard]] bool pushes_into_edges(const FlowOf<D, Real>& flow) {
    return D == 3 && flow.motion.displaces();
}

/// Those that an impact drives together, where impacts are dissipated.
template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_crowds_of_impacts(FlowOf<D, Real>& flow) {
    return flow.c.numerics.impact_dissipation > 0.0 && !pushes_into_edges(flow)
               ? std::make_unique<Crowds<D, Real>>(false, crowding_interval)
               : nullptr;
}

/// Those in the edges between walls in space: where a solid that moves pushes slow water into them, and where
/// disordered water flows along them.
template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_crowds_at_edges(FlowOf<D, Real>& flow) {
    if (pushes_into_edges(flow)) return std::make_unique<Crowds<D, Real>>(true, crowding_interval);
    return flow.c.has_side_walls() ? std::make_unique<Crowds<D, Real>>(true, crowding_interval_along_edges)
                                   : nullptr;
}

}  // namespace riffle::inline components
