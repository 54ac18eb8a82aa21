#pragma once

#include <utility>

#include "ends/end_input.hpp"
#include "ends/open_ends_state.hpp"
#include "ends/section_state.hpp"

namespace riffle::inline ends {

/// The sections at both ends in time: what the case gives there, and the characteristics that come out of the
/// channel (docs/theory.md 20).
class EndSections {
  public:
    /// `least_depth`: below it the water at an end is a film or a drop, m.
    EndSections(EndInput input, LongWaves upstream, LongWaves downstream, double sound_speed,
                double least_depth)
        : input_(std::move(input)),
          upstream_(std::move(upstream)),
          downstream_(std::move(downstream)),
          sound_speed_(sound_speed),
          least_depth_(least_depth) {}
    /// The same section at both ends.
    EndSections(EndInput input, const LongWaves& waves, double sound_speed, double least_depth)
        : EndSections(std::move(input), waves, waves, sound_speed, least_depth) {}

    [[nodiscard]] const EndInput& input() const { return input_; }
    /// Waves of the cross-sections of the ends.
    [[nodiscard]] const LongWaves& upstream() const { return upstream_; }
    [[nodiscard]] const LongWaves& downstream() const { return downstream_; }
    [[nodiscard]] const LongWaves& waves(bool at_inflow) const { return at_inflow ? upstream_ : downstream_; }
    /// Whether the ends are those of a duct.
    [[nodiscard]] bool in_duct() const { return input_.duct; }
    /// Speed of the waves that reach the ends, m/s: long waves of a depth, or sound in a duct.
    [[nodiscard]] double signal_speed(double depth) const {
        return in_duct() ? sound_speed_ : wave_speed(upstream_, depth);
    }

    /// The state of an end where the start has a depth (m) and carries a discharge (m2/s over the width of
    /// the channel).
    [[nodiscard]] EndState start(double depth, double unit_discharge, bool at_inflow = true) const;
    /// The section at the inflow after a step of dt (s), from what is watched beside it.
    void follow_upstream(EndState& end, double time, double dt) const;
    /// The same at the outflow.
    void follow_downstream(EndState& end, double time, double dt) const;

  private:
    void follow_duct_upstream(EndState& end, double time, double dt) const;
    void follow_duct_downstream(EndState& end, double dt) const;
    [[nodiscard]] double reached(const EndState& end, double depth, double dt) const;
    [[nodiscard]] Section section_of_discharge(const EndState& end, double time, double dt) const;

    EndInput input_;
    LongWaves upstream_;
    LongWaves downstream_;
    double sound_speed_;
    double least_depth_;
};

}  // namespace riffle::inline ends
