#pragma once

#include <memory>
#include <span>

#include "engine/flow.hpp"

namespace riffle::inline methods {

/// A method of time stepping: a step is a list of stages, each of which evaluates the rates by the passes
/// and, inside the last of them, moves the particles of a block.
template <int D, class Real>
class Method {
  public:
    using Flow = FlowOf<D, Real>;
    using Task = BlockTask<D, Real>;

    Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;
    virtual ~Method() = default;

    /// Evaluations of the rates per step.
    [[nodiscard]] virtual int evaluations() const = 0;
    /// The stages of the step of dt that begins; they stay until the next call.
    [[nodiscard]] virtual std::span<const Stage> begin(Flow& flow, double dt) = 0;
    /// After density and stress of a block: what the motion needs of the task later on.
    virtual void keep_rates(Flow& /*flow*/, const Task& /*task*/, std::size_t /*begin*/,
                            std::size_t /*end*/) {}
    /// Move the particles of a block by the sums of the force pass and the components' inputs.
    virtual AdvanceResult<D> move(Flow& flow, Task& task, const Stage& stage, std::size_t begin,
                                  std::size_t end) = 0;
    /// Whether all of AdvanceResult is set; else the largest acceleration and the faults alone, not the range
    /// of the velocities and the sums over the drags.
    [[nodiscard]] virtual bool sums_motion() const { return true; }
    [[nodiscard]] virtual std::size_t bytes() const { return 0; }
};

/// The method of a case, which may add fields to the particles: the one place where they are registered.
template <int D, class Real>
[[nodiscard]] std::unique_ptr<Method<D, Real>> make_method(FlowOf<D, Real>& flow);

}  // namespace riffle::inline methods
