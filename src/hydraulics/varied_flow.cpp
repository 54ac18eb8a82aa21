#include "hydraulics/varied_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "statistics/root.hpp"

namespace riffle::inline hydraulics {

namespace {

/// Within this share two depths are one: critical slopes, uniform flow.
constexpr double same_depth = 1e-4;

bool same(double depth, double other) { return std::abs(depth - other) <= same_depth * other; }

SlopeClass slope_class(const SteadyChannel& channel, double critical, std::optional<double> normal) {
    if (!normal) return channel.slope < 0.0 ? SlopeClass::adverse : SlopeClass::horizontal;
    if (same(*normal, critical)) return SlopeClass::critical;
    return *normal > critical ? SlopeClass::mild : SlopeClass::steep;
}

/// The curves that the controls of a channel give, before they are put together.
struct Curves {
    std::optional<SurfaceCurve> supercritical;  ///< from the upstream end
    std::optional<SurfaceCurve> subcritical;    ///< from the downstream end
};

void check_controls(const VariedFlow& flow, const ChannelControls& controls) {
    const double critical = flow.critical_depth;
    if (controls.upstream_depth && *controls.upstream_depth > critical * (1.0 + same_depth)) {
        throw InputError(fmt::format(
            "an upstream depth of {:.4g} m is above the critical depth of {:.4g} m: subcritical flow is ruled by "
            "its downstream end, and its depth upstream follows. Leave the upstream depth out, or give one below "
            "the critical depth",
            *controls.upstream_depth, critical));
    }
    if (controls.downstream_depth && flow.slope != SlopeClass::steep &&
        *controls.downstream_depth < critical * (1.0 - same_depth)) {
        throw InputError(fmt::format(
            "a downstream depth of {:.4g} m is below the critical depth of {:.4g} m: subcritical flow cannot end "
            "lower than that. Give the critical depth (a free overfall) or more",
            *controls.downstream_depth, critical));
    }
}

Curves curves_of(const SteadyChannel& channel, VariedFlow& flow, const ChannelControls& controls) {
    const double critical = flow.critical_depth;
    const bool steep = flow.slope == SlopeClass::steep;
    Curves curves;
    const std::optional<double> upstream =
        !controls.upstream_depth && steep ? flow.normal_depth : controls.upstream_depth;
    if (upstream) {
        curves.supercritical.emplace(channel, 0.0, std::min(*upstream, critical), 1, controls.length,
                                     critical, flow.normal_depth);
    }
    const std::optional<double> downstream =
        !controls.downstream_depth && !steep ? flow.normal_depth : controls.downstream_depth;
    if (downstream && (!steep || *downstream > critical * (1.0 + same_depth))) {
        curves.subcritical.emplace(channel, controls.length, std::max(*downstream, critical), -1,
                                   controls.length, critical, flow.normal_depth);
    } else if (downstream && !same(*downstream, *flow.normal_depth)) {
        flow.events.push_back(fmt::format(
            "The downstream depth of {:.4g} m is not above the critical depth of {:.4g} m: supercritical flow does not feel it.",
            *downstream, critical));
    }
    const bool filled =
        curves.subcritical || (curves.supercritical && !curves.supercritical->ends_critical());
    if (!filled) {
        throw InputError(
            "a bed that does not fall has no normal depth, from which the flow could come: give the depth at the "
            "downstream end");
    }
    return curves;
}

/// Where the jump between both curves stands; at an end, with an event, where it has no place in the channel.
double place_of_jump(const SteadyChannel& channel, const Curves& curves, VariedFlow& flow, double length) {
    const double from = std::max(0.0, curves.subcritical->end());
    const double to = std::min(length, curves.supercritical->end());
    const auto surplus = [&](double x) {
        return channel.momentum(curves.supercritical->depth_at(x)) -
               channel.momentum(curves.subcritical->depth_at(x));
    };
    const double inflow = curves.supercritical->depth_at(0.0);
    if (surplus(from) <= 0.0 && same(inflow, flow.critical_depth)) {
        flow.events.push_back(fmt::format(
            "The depth given upstream is critical, and the downstream end backs up to {:.4g} m there: the flow is "
            "subcritical throughout.",
            curves.subcritical->depth_at(0.0)));
        return 0.0;
    }
    if (surplus(from) <= 0.0) {
        flow.events.push_back(fmt::format(
            "The jump is drowned at the upstream end: the sequent depth of {:.4g} m is {:.4g} m, less than the "
            "{:.4g} m that the downstream end backs up to there. The flow is subcritical throughout.",
            inflow, sequent_depth(channel, inflow, flow.critical_depth).value_or(0.0),
            curves.subcritical->depth_at(0.0)));
        return 0.0;
    }
    if (surplus(to) >= 0.0) {
        flow.events.push_back(fmt::format(
            "The jump is swept out of the downstream end: a depth of {:.4g} m holds it not, {:.4g} m would. The "
            "flow is supercritical throughout.",
            curves.subcritical->depth_at(length),
            sequent_depth(channel, curves.supercritical->depth_at(length), flow.critical_depth)
                .value_or(0.0)));
        return length;
    }
    return root_between(surplus, from, to);
}

/// A curve's part of the channel.
void add_profile(VariedFlow& flow, const SurfaceCurve& curve, double from, double to) {
    if (!(to > from)) return;
    SurfaceProfile part{{}, from, to, curve.depth_at(from), curve.depth_at(to), curve};
    part.name = profile_name(0.5 * (part.depth_from + part.depth_to), flow.critical_depth, flow.normal_depth,
                             flow.slope);
    flow.profiles.push_back(std::move(part));
}

}  // namespace

double VariedFlow::depth_at(double x) const { return profile_at(x).depth_at(x); }

const SurfaceProfile& VariedFlow::profile_at(double x) const {
    const auto at = std::find_if(profiles.rbegin(), profiles.rend(),
                                 [x](const SurfaceProfile& part) { return x >= part.from; });
    return at == profiles.rend() ? profiles.front() : *at;
}

std::string profile_name(double depth, double critical_depth, std::optional<double> normal_depth,
                         SlopeClass slope) {
    if (normal_depth && same(depth, *normal_depth)) return "uniform";
    const bool above = depth > critical_depth;
    switch (slope) {
        case SlopeClass::mild:
            return depth > *normal_depth ? "M1" : above ? "M2" : "M3";
        case SlopeClass::steep:
            return above ? "S1" : depth > *normal_depth ? "S2" : "S3";
        case SlopeClass::critical:
            return above ? "C1" : "C3";
        case SlopeClass::horizontal:
            return above ? "H2" : "H3";
        case SlopeClass::adverse:
            return above ? "A2" : "A3";
    }
    return {};
}

namespace {

/// Classify the channel. On a critical slope the slope is changed by the hair that makes normal and critical
/// depth one, so that neither curve has a pole beside its end.
VariedFlow classify(SteadyChannel& channel, const ChannelControls& controls) {
    VariedFlow flow;
    flow.critical_depth = critical_depth(channel);
    flow.normal_depth = normal_depth(channel);
    flow.slope = slope_class(channel, flow.critical_depth, flow.normal_depth);
    if (flow.slope == SlopeClass::critical) {
        channel.slope = std::tan(std::asin(channel.state(flow.critical_depth).friction_slope));
        flow.critical_depth = critical_depth(channel);
        flow.normal_depth = flow.critical_depth;
    }
    check_controls(flow, controls);
    return flow;
}

/// On a critical slope both curves may end at the critical depth, with uniform flow between them.
bool meet_at_critical(const VariedFlow& flow, const Curves& curves) {
    if (flow.slope != SlopeClass::critical) return false;
    return !curves.supercritical || !curves.subcritical ||
           curves.supercritical->end() <= curves.subcritical->end();
}

}  // namespace

VariedFlow solve_varied_flow(const SteadyChannel& given, const ChannelControls& controls) {
    SteadyChannel channel = given;
    VariedFlow flow = classify(channel, controls);
    const Curves curves = curves_of(channel, flow, controls);
    const double length = controls.length;
    if (meet_at_critical(flow, curves)) {
        const double from = curves.supercritical ? curves.supercritical->end() : 0.0;
        const double to = curves.subcritical ? curves.subcritical->end() : length;
        const SurfaceCurve uniform(channel, 0.0, flow.critical_depth, 1, length, flow.critical_depth,
                                   flow.critical_depth);
        if (curves.supercritical) add_profile(flow, *curves.supercritical, 0.0, from);
        add_profile(flow, uniform, from, to);
        if (curves.subcritical) add_profile(flow, *curves.subcritical, to, length);
        return flow;
    }
    if (!curves.supercritical || !curves.subcritical) {
        add_profile(flow, curves.subcritical ? *curves.subcritical : *curves.supercritical, 0.0, length);
        return flow;
    }
    const double place = place_of_jump(channel, curves, flow, length);
    add_profile(flow, *curves.supercritical, 0.0, place);
    add_profile(flow, *curves.subcritical, place, length);
    if (place > 0.0 && place < length) {
        const double before = curves.supercritical->depth_at(place);
        const double after = curves.subcritical->depth_at(place);
        flow.jump = {place, before, after, channel.froude_number(before),
                     channel.energy_head(before) - channel.energy_head(after)};
    }
    return flow;
}

std::optional<double> approach_length(const SteadyChannel& given, const ChannelControls& controls,
                                      double share) {
    SteadyChannel channel = given;
    VariedFlow flow = classify(channel, controls);
    const bool steep = flow.slope == SlopeClass::steep;
    const bool ruled_downstream =
        controls.downstream_depth && *controls.downstream_depth > flow.critical_depth;
    if (!flow.normal_depth || (steep ? ruled_downstream : controls.upstream_depth.has_value())) {
        return std::nullopt;
    }
    ChannelControls endless = controls;
    constexpr double far = 1e12;
    endless.length = far;
    const Curves curves = curves_of(channel, flow, endless);
    return (steep ? curves.supercritical : curves.subcritical)->distance_within(share);
}

}  // namespace riffle::inline hydraulics
