#pragma once

#include <string>
#include <vector>

#include "hydraulics/varied_flow.hpp"

namespace riffle::inline hydraulics {

/// A stretch of a channel with one bed, and what the discharge does on it.
struct Reach {
    std::string name;   ///< of a patch of the bed; empty for the bed of the channel
    double from = 0.0;  ///< m from the upstream end
    double to = 0.0;
    SteadyChannel channel;
};

/// Steady flow over several beds one behind the other, subcritical all along: from the downstream end up each
/// reach has the depth at its end with which the momentum function goes on over the edge, beta q^2/H + g
/// cos(theta) H^2/2 of both beds (the profile of the velocity, and with it beta, changes there, so that the
/// depth has a step; the flow takes some ten depths for it). Of one reach solve_varied_flow(). Throws
/// InputError where the flow becomes supercritical in a reach or at an edge, and as solve_varied_flow().
[[nodiscard]] VariedFlow solve_varied_reaches(const std::vector<Reach>& reaches,
                                              const ChannelControls& controls);

}  // namespace riffle::inline hydraulics
