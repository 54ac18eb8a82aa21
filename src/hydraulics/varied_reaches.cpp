#include "hydraulics/varied_reaches.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "statistics/root.hpp"

namespace riffle::inline hydraulics {

namespace {

[[noreturn]] void refuse_supercritical(const Reach& reach) {
    throw InputError(fmt::format(
        "the flow becomes supercritical {}, from {:.4g} to {:.4g} m: over beds of several roughnesses it is "
        "solved where it is subcritical all along; give a deeper downstream end, or a case of one bed for each "
        "reach",
        reach.name.empty() ? "over the bed of the channel" : "over the patch \"" + reach.name + "\"",
        reach.from, reach.to));
}

/// The subcritical depth at the end of a reach whose momentum function is that of the depth below the edge.
double depth_over_edge(const Reach& reach, double critical, const Reach& below, double depth_below) {
    const auto surplus = [&](double depth) {
        return reach.channel.momentum(depth) - below.channel.momentum(depth_below);
    };
    if (surplus(critical) >= 0.0) refuse_supercritical(reach);
    double high = 2.0 * depth_below;
    while (surplus(high) < 0.0) high *= 2.0;
    return root_between(surplus, critical, high);
}

}  // namespace

VariedFlow solve_varied_reaches(const std::vector<Reach>& reaches, const ChannelControls& controls) {
    if (reaches.size() == 1) return solve_varied_flow(reaches.front().channel, controls);
    if (controls.upstream_depth) refuse_supercritical(reaches.front());
    VariedFlow whole;
    ChannelControls of_reach = controls;
    for (std::size_t i = reaches.size(); i-- > 0;) {
        const Reach& reach = reaches[i];
        of_reach.length = reach.to - reach.from;
        if (i + 1 < reaches.size()) {
            const double below = whole.profiles.front().depth_from;
            of_reach.downstream_depth =
                depth_over_edge(reach, critical_depth(reach.channel), reaches[i + 1], below);
        }
        VariedFlow flow = solve_varied_flow(reach.channel, of_reach);
        if (flow.jump || flow.depth_at(0.0) < flow.critical_depth * (1.0 - 1e-9) ||
            flow.profiles.size() != 1) {
            refuse_supercritical(reach);
        }
        SurfaceProfile part = std::move(flow.profiles.front());
        part.origin = reach.from;
        part.from = reach.from;
        part.to = reach.to;
        whole.profiles.insert(whole.profiles.begin(), std::move(part));
        whole.reaches.insert(whole.reaches.begin(), {reach.name, reach.from, reach.to, flow.slope,
                                                     flow.critical_depth, flow.normal_depth});
        whole.events.insert(whole.events.begin(), flow.events.begin(), flow.events.end());
    }
    const VariedReach& last = whole.reaches.back();
    whole.slope = last.slope;
    whole.critical_depth = last.critical_depth;
    whole.normal_depth = last.normal_depth;
    return whole;
}

}  // namespace riffle::inline hydraulics
