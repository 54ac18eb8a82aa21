#pragma once

#include <memory>
#include <vector>

#include "walls/wall_treatment.hpp"

namespace riffle::inline walls {

/// The walls and solids of a flow: where their particles stand, how they move, and how they are treated.
template <int D, class Real>
class Walls {
  public:
    using Flow = FlowOf<D, Real>;
    using Task = BlockTask<D, Real>;

    /// Puts the wall particles of the case into the flow, not sorted yet.
    explicit Walls(Flow& flow);

    /// Sort and pack the walls, with the state of the start.
    void place_at_start(Flow& flow);
    /// Put the state of a checkpoint back, whose clock the flow has.
    void restore(Flow& flow, std::vector<double> deviation);

    /// Lists are about to be built of the sorted particles.
    void place_for_lists(Flow& flow);
    void lists_built(Flow& flow, double reach);
    /// Put the wall particles of solids that move where the bodies are now: what looks at them before the
    /// evaluations of a step finds the same in a run that goes on as in one that did not stop.
    void bring_to_clock(Flow& flow);
    /// Where the walls stand at the time of an evaluation, and how they move, into their records.
    void move(Flow& flow, const Stage& stage);
    /// Widen the range of velocities by those of the solids in the step that begins now.
    void add_motion(const Flow& flow, double step, Vec<D>& slowest, Vec<D>& fastest) const;

    /// Whether the lists hold by the bound of all velocities alone: walls change their place, or what they
    /// look at is in no list of clusters.
    [[nodiscard]] bool outside_of_lists(const Flow& flow) const {
        return flow.motion.displaces() || looks_at_all_water(flow);
    }
    [[nodiscard]] bool looks_at_all_water(const Flow& flow) const {
        return flow.walls.size() > 0 && treatment_->looks_at_all_water();
    }
    void look_at_water(Flow& flow) { treatment_->look_at_water(flow); }
    void update(Flow& flow, Task& task, const Stage& stage, std::size_t begin, std::size_t end) {
        treatment_->update(flow, task, stage, begin, end);
    }
    [[nodiscard]] std::size_t bytes() const { return treatment_->bytes(); }

  private:
    void set_hydrostatic(Flow& flow) const;
    /// Sort the walls in space and cut them into clusters; the order that they had before.
    static std::vector<std::int32_t> sort(Flow& flow);
    /// Put the walls where they stand with their bodies, sort and pack them.
    void place(Flow& flow, const std::vector<BodyState>& bodies);
    /// Place and normal of a wall particle with its body; returns its velocity. `reference`: its number at
    /// t = 0.
    Vec<3> stand(Flow& flow, std::size_t i, std::size_t reference, const BodyState& body) const;
    /// Put the wall particles of solids and their records where these bodies are, and tell of each
    /// `moved(slot, particle, velocity)`.
    template <class Moved>
    void stand_solids(Flow& flow, const std::vector<BodyState>& bodies, const Moved& moved);
    /// A coordinate along axis k in the domain.
    static double within(const Flow& flow, double x, std::size_t k);
    /// How far the particles of each body are from the point that it turns about.
    void measure_reach(const Flow& flow);

    std::unique_ptr<WallTreatment<D, Real>> treatment_;
    WallParticles<D> reference_;       ///< at t = 0 in their first order; only where walls change place
    std::vector<std::int32_t> order_;  ///< of the flow's walls: number in reference_
    std::vector<double> reach_;        ///< of each body, m
};

}  // namespace riffle::inline walls
