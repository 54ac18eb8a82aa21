#pragma once

#include <cmath>
#include <memory>

#include "engine/component.hpp"
#include "sph/correction.hpp"

namespace riffle::inline components {

/// A drag that takes the motion out of still water at the beginning of a run: what the arrangement of the
/// start lacks of its balance becomes no motion that lasts. It is critical for the longest wave that a basin
/// as long as deep has, and fades over the second half of its time.
template <int D, class Real>
class Settling final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit Settling(Flow& flow)
        : time_(flow.c.start.settling_time),
          rate_(4.0 * std::sqrt(flow.c.normal_gravity() / flow.scheme.depth)) {
        flow.inputs.acceleration = true;
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        if (flow.clock.time >= time_) return;
        const double rate = rate_ * (1.0 - smoothstep<double>(0.5, 1.0, flow.clock.time / time_));
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                task.particles.acceleration[k][lane] -= rate * flow.particles.velocity[k][i];
            }
        });
    }

  private:
    double time_;  ///< s
    double rate_;  ///< 1/s
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_settling(FlowOf<D, Real>& flow) {
    return flow.c.start.settling_time > 0.0 ? std::make_unique<Settling<D, Real>>(flow) : nullptr;
}

}  // namespace riffle::inline components
