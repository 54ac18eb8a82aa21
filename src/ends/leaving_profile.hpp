#pragma once

#include <vector>

#include "ends/open_ends_state.hpp"

namespace riffle::inline ends {

/// The velocity profile of the water that leaves: that of the water before the outflow, smoothed over the
/// time that a wave takes along one depth. (Were water to keep its own velocity, slow water at the bed could
/// come to rest beyond the end and dam the channel.) The profile in bins over the depth is part of the state.
class LeavingProfile {
  public:
    /// `least_depth`: that of a film or a drop, m.
    explicit LeavingProfile(double least_depth) : least_depth_(least_depth) {}

    /// Begin to gather the water before the outflow.
    void clear(const OpenEndsState& state);
    /// Water at a height (m): its weight and its velocity along the channel.
    void add(const OpenEndsState& state, double z, double weight, double velocity) {
        const std::size_t bin = bin_of(state, z / depth_);
        weight_[bin] += weight;
        flux_[bin] += weight * velocity;
    }
    /// Take over what has been gathered in a step of dt (s), smoothed over the time of a depth at a speed
    /// (m/s). The mean of the profile is then that of the section: by a factor, so that slow water stays
    /// slow, unless the flow turns.
    void finish(OpenEndsState& state, double speed, double dt);
    /// Go on with the profile of a state that has been restored.
    void go_on(const OpenEndsState& state);

    /// Velocity along the channel at z/h. While the flow as a whole leaves, none of it comes back: nothing
    /// would be there to come.
    [[nodiscard]] double at(const OpenEndsState& state, double place) const;

  private:
    [[nodiscard]] static std::size_t bin_of(const OpenEndsState& state, double place);

    double least_depth_;
    double depth_ = 0.0;                 ///< of the water that is gathered, m
    double factor_ = 1.0;                ///< from the profile to that of its section
    double shift_ = 0.0;                 ///< so, m/s
    std::vector<double> weight_, flux_;  ///< by bin
};

}  // namespace riffle::inline ends
