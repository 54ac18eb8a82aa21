#include "ends/end_events.hpp"

#include <fmt/format.h>

#include "ends/section_state.hpp"

namespace riffle::inline ends {

namespace {

// Each event is over where its opposite is clear, so that one that trembles is told once.
constexpr double wet_again = 2.0;        // over the depth of a film
constexpr double back_share = 0.02;      // of the speed of waves: water that swings is not told
constexpr double shooting_share = 1.25;  // of it, where the flow has come back
constexpr int most_times = 5;            // that an event is told

}  // namespace

void EndEvents::go_on(const OpenEndsState& ends) {
    wetted_ = true;
    (void)news(ends, 0.0);
}

std::vector<std::string> EndEvents::news(const OpenEndsState& ends, double time) {
    std::vector<std::string> told;
    if (!ends.begun) return told;
    const auto change = [&](Event& event, bool begins, bool is_over, const auto& beginning, const auto& end) {
        if (event.lasts ? !is_over : !begins) return;
        event.lasts = !event.lasts;
        event.times += event.lasts ? 1 : 0;
        if (event.times <= most_times) told.push_back(event.lasts ? beginning() : end());
    };

    const EndState& out = ends.downstream;
    const double watched = out.watched_depth - waves_.lowest();
    const bool is_wet = watched > wet_again * least_depth_;
    const bool was_wetted = wetted_;
    wetted_ = wetted_ || is_wet;
    change(
        dry_, (wetted_ || holds_) && watched < least_depth_, is_wet,
        [&] {
            return wetted_
                       ? fmt::format(
                             "the outflow ran dry at t = {:.4g} s: less than a row of particles is left there",
                             time)
                       : fmt::format(
                             "the outflow is dry at t = {:.4g} s: it holds the depth of [outflow] from when "
                             "water reaches it, and lets none in before",
                             time);
        },
        [&] {
            return fmt::format("there is water at the outflow{} at t = {:.4g} s", was_wetted ? " again" : "",
                               time);
        });

    const double swing = back_share * wave_speed(waves_, out.depth);
    const bool leaves = out.velocity > swing;
    change(
        reversed_, out.velocity < -swing, leaves,
        [&] {
            return fmt::format(
                "water comes in through the outflow from t = {:.4g} s on: what is beyond it is as deep as [outflow] "
                "says",
                time);
        },
        [&] { return fmt::format("water leaves through the outflow again from t = {:.4g} s on", time); });

    const EndState& in = ends.upstream;
    change(
        drowned_,
        in.velocity > wave_speed(upstream_, in.depth) && in.watched_depth > drowned_share * in.depth,
        in.watched_depth < shooting_share * in.depth,
        [&] {
            return fmt::format(
                "at t = {:.4g} s the water beside the inflow is {:.3g} m deep, where {:.3g} m enter faster than their "
                "waves: a jump has reached the inflow, or the start stands there. A lower depth at the outflow or a "
                "longer channel lets it stand off",
                time, in.watched_depth, in.depth);
        },
        [&] { return fmt::format("the water beside the inflow shoots again from t = {:.4g} s on", time); });
    return told;
}

}  // namespace riffle::inline ends
