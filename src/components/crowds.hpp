#pragma once

#include "engine/component.hpp"
#include "sph/crowding.hpp"

namespace riffle {

/// With dissipation of impacts, each `crowding_interval` steps: raise the density of crowded particles.
template <int D, class Real>
class Crowds final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;

    void begin_step(Flow& flow, double dt) override {
        if (flow.clock.steps % crowding_interval != 0) {
            return;
        }
        const Scheme& scheme = flow.scheme;
        const double turns = crowding_interval * dt * scheme.state.sound_speed / scheme.smoothing_length;
        flow.for_moments([&](const FilterResult<D, Real>& sums, std::size_t particle, std::size_t lane) {
            flow.particles.density_deviation[particle] +=
                turns * crowding_rate(static_cast<double>(sums.zeroth[lane]));
        });
        flow.repack();
    }
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_crowds(FlowOf<D, Real>& flow) {
    return flow.c.numerics.impact_dissipation > 0.0 ? std::make_unique<Crowds<D, Real>>() : nullptr;
}

}  // namespace riffle
