#pragma once

#include <utility>

#include "boundary/repulsive_wall.hpp"
#include "engine/component.hpp"

namespace riffle::inline components {

/// The push of repulsive walls.
template <int D, class Real>
class Repulsion final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    Repulsion(Flow& flow, RepulsiveWalls<D> walls) : walls_(std::move(walls)) {
        flow.inputs.acceleration = true;
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const Vec<D> a = walls_.acceleration(vector_of(flow.particles.position, i),
                                                 vector_of(flow.particles.velocity, i));
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                task.wall_acceleration[k][lane] += a[k];
                task.particles.acceleration[k][lane] += a[k];
            }
        });
    }

  private:
    RepulsiveWalls<D> walls_;
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_repulsion(FlowOf<D, Real>& flow) {
    RepulsiveWalls<D> walls(flow.c, flow.scheme.state.sound_speed);
    return walls.active() ? std::make_unique<Repulsion<D, Real>>(flow, std::move(walls)) : nullptr;
}

}  // namespace riffle::inline components
