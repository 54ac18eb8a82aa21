#pragma once

#include "engine/flow.hpp"

namespace riffle::inline engine {

/// A part of the model beside the sums of the pair loops: closure, drag, a force, a filter, contact. Its
/// hooks are called in this order in each step; those of blocks by several threads at a time, each for blocks
/// [begin, end) of clusters of its own. A component that adds an input to the motion says so in
/// FlowOf::inputs when it is made. Which components a case has: make_components()
/// (components/components.hpp).
template <int D, class Real>
class Component {
  public:
    using Flow = FlowOf<D, Real>;
    using Task = BlockTask<D, Real>;

    Component() = default;
    Component(const Component&) = delete;
    Component& operator=(const Component&) = delete;
    virtual ~Component() = default;

    /// Whether the lists must be built anew, whatever the particles' displacements.
    [[nodiscard]] virtual bool lists_expired(const Flow& /*flow*/) const { return false; }
    /// Lists are about to be built anew, the particles not sorted yet: they may be made and taken out.
    virtual void before_lists(Flow& /*flow*/) {}
    /// The particles have been sorted, lists are about to be built.
    virtual void particles_sorted(const Flow& /*flow*/) {}
    /// The lists have been built, at a resume too: those of a saved state.
    virtual void lists_built(const Flow& /*flow*/) {}
    /// Before the length of the step is chosen.
    virtual void before_step(Flow& /*flow*/) {}
    /// Whether begin_step() of the step that begins looks at wall particles: those of solids that move are
    /// then brought to where the bodies are now.
    [[nodiscard]] virtual bool looks_at_walls(const Flow& /*flow*/) const { return false; }
    /// A step of dt begins; Flow::keep_fields says whether its fields are kept.
    virtual void begin_step(Flow& /*flow*/, double /*dt*/) {}
    /// Before the passes of an evaluation, when the walls are where they are in it.
    virtual void begin_evaluation(Flow& /*flow*/, const Stage& /*stage*/) {}

    /// After the sums of the gradient pass of a block, before density and stress follow from them.
    virtual void complete_gradients(Flow& /*flow*/, Task& /*task*/, std::size_t /*begin*/,
                                    std::size_t /*end*/) {}
    /// After the sums of the force pass of a block, before its motion: drags, accelerations, transport.
    virtual void add_forces(Flow& /*flow*/, Task& /*task*/, std::size_t /*begin*/, std::size_t /*end*/) {}
    /// After the motion of a block, before its records are packed.
    virtual void after_motion(Flow& /*flow*/, Task& /*task*/, const Stage& /*stage*/, std::size_t /*begin*/,
                              std::size_t /*end*/) {}

    /// After the passes of an evaluation.
    virtual void end_evaluation(Flow& /*flow*/) {}
    virtual void end_step(Flow& /*flow*/) {}

    /// Bytes of its arrays.
    [[nodiscard]] virtual std::size_t bytes() const { return 0; }
};

}  // namespace riffle::inline engine
