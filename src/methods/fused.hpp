#pragma once

#include <array>

#include "methods/method.hpp"

namespace riffle::inline methods {

/// Methods of one evaluation, whose motion is fused with the passes (ParticleLoops::advance): density,
/// pressure, walls, forces, velocity, position, each with the newest of the others. The drags are implicit:
/// u1 + dt beta u1|u1| = u*.
template <int D, class Real>
class FusedMethod : public Method<D, Real> {
  public:
    using typename Method<D, Real>::Flow;
    using typename Method<D, Real>::Task;

    [[nodiscard]] int evaluations() const final { return 1; }
    AdvanceResult<D> move(Flow& flow, Task& task, const Stage& stage, std::size_t begin,
                          std::size_t end) final {
        AdvanceOptions options = flow.inputs;
        options.step = stage.motion;
        options.kick = stage.kick;
        return flow.particle_loops.advance(flow.particle_data, task.sums, task.particles, options, begin,
                                           end);
    }

  protected:
    std::array<Stage, 1> stage_;
};

/// First order; disordered water swells.
template <int D, class Real>
class SemiImplicitEuler final : public FusedMethod<D, Real> {
  public:
    std::span<const Stage> begin(FlowOf<D, Real>& /*flow*/, double dt) override {
        this->stage_[0] = {.density = dt, .wall = dt, .motion = dt};
        return this->stage_;
    }
};

/// Velocities stand half a step before the positions: those that brought the particles here say how the
/// density has changed on the way, over the step that has been taken. What the middle of the way adds to the
/// sum at its end changes slowly in layers: every other step takes it there, twice.
template <int D, class Real>
class Leapfrog final : public FusedMethod<D, Real> {
  public:
    explicit Leapfrog(const Case& c) : interval_(midway_interval(c)) {}

    std::span<const Stage> begin(FlowOf<D, Real>& flow, double dt) override {
        const double before = flow.clock.time_step;
        flow.data.constants.half_way =
            static_cast<Real>(0.5 * interval_ * before / flow.scheme.smoothing_length);
        this->stage_[0] = {.density = before,
                           .wall = before,
                           .motion = dt,
                           .kick = 0.5 * (before + dt),
                           .midway = flow.clock.steps % interval_ == 0};
        return this->stage_;
    }

  private:
    int interval_;
};

}  // namespace riffle::inline methods
