#include "ends/section_state.hpp"

#include <algorithm>
#include <cmath>

#include "case/end_levels.hpp"

namespace riffle::inline ends {

double wave_speed(double gravity, double depth) { return std::sqrt(gravity * std::max(0.0, depth)); }

double invariant_of_critical_flow(double going) { return going > 0.0 ? -going / 3.0 : -going; }

double sequent_depth(double gravity, const Section& before) {
    const double c = wave_speed(gravity, before.depth);
    const double froude = c > 0.0 ? before.velocity / c : 0.0;
    return 0.5 * before.depth * (std::sqrt(1.0 + 8.0 * froude * froude) - 1.0);
}

Section inflow_by_discharge(double gravity, double unit_discharge, double coming) {
    // g q/c^2 - 2 c = coming has one root: the left side falls and is convex, so that Newton's steps rise to
    // it from the second one on.
    const double critical = wave_speed(gravity, critical_depth_of(gravity, unit_discharge));
    double c = std::max({critical, -coming, 1e-6});
    constexpr int most_iterations = 50;
    for (int i = 0; i < most_iterations; ++i) {
        const double excess = gravity * unit_discharge / (c * c) - 2.0 * c - coming;
        const double slope = -2.0 * gravity * unit_discharge / (c * c * c) - 2.0;
        const double next = std::max(0.5 * c, c - excess / slope);
        const bool found = std::abs(next - c) <= 1e-14 * c;
        c = next;
        if (found) break;
    }
    c = std::max(c, critical);
    const double depth = c * c / gravity;
    return {depth, depth > 0.0 ? unit_discharge / depth : 0.0};
}

Section inflow_by_depth(double gravity, double depth, double coming) {
    return {depth, coming + 2.0 * wave_speed(gravity, depth)};
}

double invariant_of_discharge(double gravity, const Section& now, double change) {
    return change / (0.5 * now.depth * (1.0 + now.velocity / wave_speed(gravity, now.depth)));
}

double invariant_of_depth(double gravity, const Section& now, double change) {
    return -2.0 * std::sqrt(gravity / now.depth) * change;
}

Section outflow_between(double gravity, double going, double coming) {
    const double c = std::max(0.0, 0.25 * (going - coming));
    return {c * c / gravity, 0.5 * (going + coming)};
}

double relaxation(double gravity, const Section& now, double depth, double time, double dt) {
    return 2.0 * std::sqrt(gravity / now.depth) * (now.depth - depth) * dt / time;
}

}  // namespace riffle::inline ends
