#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ends/long_waves.hpp"
#include "ends/open_ends_state.hpp"

namespace riffle::inline ends {

/// Of the depth that is to enter faster than its waves: deeper water beside the inflow drowns it. A jump at
/// Fr = 1.3 makes 1.4 of it.
inline constexpr double drowned_share = 1.5;

/// What happens at the open ends of a channel that whoever runs it should know of: the outflow runs dry, or
/// waits for water to hold, or water comes in through it; a jump reaches the inflow, and what enters is not
/// the shooting flow that the case gives. Each is told when it begins and when it is over, the first times
/// that it happens.
class EndEvents {
  public:
    /// Waves of the cross-sections of the ends; `least_depth`: that of a film or a drop, m; `holds`:
    /// whether the case gives the depth at the outflow.
    EndEvents(LongWaves upstream, LongWaves downstream, double least_depth, bool holds)
        : upstream_(std::move(upstream)),
          waves_(std::move(downstream)),
          least_depth_(least_depth),
          holds_(holds) {}
    /// The same section at both ends.
    EndEvents(const LongWaves& waves, double least_depth, bool holds)
        : EndEvents(waves, waves, least_depth, holds) {}

    /// Go on with ends that have been restored: what lasts there has been told.
    void go_on(const OpenEndsState& ends);

    /// Sentences about what has changed since the last call; `time` in s.
    [[nodiscard]] std::vector<std::string> news(const OpenEndsState& ends, double time);

  private:
    struct Event {
        bool lasts = false;
        int times = 0;
    };

    LongWaves upstream_;
    LongWaves waves_;  ///< at the outflow
    double least_depth_;
    bool holds_;
    bool wetted_ = false;  ///< there has been water at the outflow
    Event dry_;            ///< there is none any more, or none yet to hold
    Event reversed_;       ///< water comes in through the outflow
    Event drowned_;        ///< deeper water stands at a supercritical inflow
};

}  // namespace riffle::inline ends
