#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
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
    /// Of a cross-section: a profile in each of its files, over the water above its bed there, of the same
    /// number of bins.
    LeavingProfile(double least_depth, std::vector<double> floors)
        : least_depth_(least_depth), floors_(std::move(floors)) {}

    /// Begin to gather the water before the outflow.
    void clear(const OpenEndsState& state);
    /// Water at a height (m), in a file of a section: its weight and its velocity along the channel.
    void add(const OpenEndsState& state, double z, double weight, double velocity, std::size_t file = 0) {
        const std::size_t bin = first_of(state, file) + bin_of(state, place_in_file(z, depth_, file));
        weight_[bin] += weight;
        flux_[bin] += weight * velocity;
    }
    /// Take over what has been gathered in a step of dt (s), smoothed over the time of a depth at a speed
    /// (m/s). The mean of the profile is then that of the section: by a factor, so that slow water stays
    /// slow, unless the flow turns.
    void finish(OpenEndsState& state, double speed, double dt);
    /// Go on with the profile of a state that has been restored.
    void go_on(const OpenEndsState& state);

    /// Velocity along the channel at a height over the depth (m), in a file of a section. While the flow as a
    /// whole leaves, none of it comes back: nothing would be there to come.
    [[nodiscard]] double at(const OpenEndsState& state, double height, double depth,
                            std::size_t file = 0) const;

  private:
    [[nodiscard]] std::size_t files() const { return std::max<std::size_t>(1, floors_.size()); }
    /// Bins of a profile, and the first one of a file.
    [[nodiscard]] std::size_t bins(const OpenEndsState& state) const {
        return state.leaving.size() / files();
    }
    [[nodiscard]] std::size_t first_of(const OpenEndsState& state, std::size_t file) const {
        return file * bins(state);
    }
    [[nodiscard]] std::size_t bin_of(const OpenEndsState& state, double place) const;
    /// Place of a height over the water of a depth (m) in a file, from 0 to 1.
    [[nodiscard]] double place_in_file(double height, double depth, std::size_t file) const {
        return floors_.empty() ? height / depth
                               : (height - floors_[file]) / std::max(depth - floors_[file], least_depth_);
    }
    /// Mean velocity of the profiles over the water of a depth.
    [[nodiscard]] double mean_over(const OpenEndsState& state, double depth) const;

    double least_depth_;
    std::vector<double> floors_;         ///< by file, over the floor of the section, m; empty: one profile
    double depth_ = 0.0;                 ///< of the water that is gathered, m
    double factor_ = 1.0;                ///< from the profile to that of its section
    double shift_ = 0.0;                 ///< so, m/s
    std::vector<double> weight_, flux_;  ///< by bin
};

}  // namespace riffle::inline ends
