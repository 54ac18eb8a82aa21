#pragma once

#include <algorithm>
#include <memory>

#include "boundary/wall.hpp"
#include "engine/flow.hpp"

namespace riffle::inline walls {

/// How wall particles find the pressure and the velocity with which they act on the water: `numerics.wall`.
template <int D, class Real>
class WallTreatment {
  public:
    using Flow = FlowOf<D, Real>;
    using Task = BlockTask<D, Real>;

    explicit WallTreatment(const Case& c) : action_(wall_action(c)) {}
    WallTreatment(const WallTreatment&) = delete;
    WallTreatment& operator=(const WallTreatment&) = delete;
    virtual ~WallTreatment() = default;

    /// The walls stand in a new order or at new places; their records are packed.
    virtual void walls_placed(Flow& /*flow*/) {}
    /// Lists of so far a reach (m) have been built; the clusters of the water still have their boxes.
    virtual void lists_built(Flow& /*flow*/, double /*reach*/) {}
    /// Whether look_at_water() is wanted: the passes then run one after the other, each over all blocks.
    [[nodiscard]] virtual bool looks_at_all_water() const { return false; }
    /// Between the gradients of all water and the walls.
    virtual void look_at_water(Flow& /*flow*/) {}
    /// Pressure and velocity of the particles of a block of clusters of the walls.
    virtual void update(Flow& flow, Task& task, const Stage& stage, std::size_t begin, std::size_t end) = 0;
    [[nodiscard]] virtual std::size_t bytes() const { return 0; }

    /// wet() of all wall particles, by their density deviation.
    virtual void wet(Flow& flow) const {
        for_walls(flow, 0, flow.wall_clusters.size(), [&](std::size_t slot, std::size_t i) {
            wet(flow, slot, i, flow.scheme.state.pressure(flow.walls.density_deviation[i]));
        });
    }

  protected:
    [[nodiscard]] const WallAction& action() const { return action_; }

    /// Call f(slot, particle) for the wall particles of clusters [begin, end).
    template <class F>
    static void for_walls(const Flow& flow, std::size_t begin, std::size_t end, const F& f) {
        for (std::size_t slot = begin * cluster_size; slot < end * cluster_size; ++slot) {
            const std::int32_t particle = flow.wall_clusters.particle_of(slot);
            if (particle >= 0) f(slot, static_cast<std::size_t>(particle));
        }
    }

    /// An end wall stands higher than the water, and so may a solid. Their particles above the surface, where
    /// the extrapolated pressure is negative, must be as empty as the space over the rest of the surface, or
    /// they pull at the water below: their volume fades out over one spacing. Where there is no surface a
    /// pressure below zero is one like any other.
    void wet(Flow& flow, std::size_t slot, std::size_t particle, double pressure) const {
        constexpr std::size_t vertical = Flow::vertical;
        if ((flow.walls.normal[vertical][particle] != 0.0 && !is_solid(flow.walls, particle)) ||
            flow.scheme.normal_gravity <= 0.0 || flow.c.channel.top != Top::free_surface) {
            return;
        }
        const double wetness =
            std::clamp(0.5 + pressure / (flow.scheme.normal_gravity * flow.c.numerics.spacing), 0.0, 1.0);
        const auto volume = static_cast<Real>(wetness * flow.walls.volume[particle]);
        flow.data.wall_gradient[slot].volume = volume;
        flow.data.wall_force[slot].weight = volume;
        flow.data.wall_force[slot].viscous_weight = action_.rests_at(flow.walls, particle) ? volume : Real(0);
    }

  private:
    WallAction action_;
};

/// The treatment of a case: the one place where they are registered.
template <int D, class Real>
[[nodiscard]] std::unique_ptr<WallTreatment<D, Real>> make_wall_treatment(const Case& c);

}  // namespace riffle::inline walls
