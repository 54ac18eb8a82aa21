#include "ends/section_state.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/root.hpp"

namespace riffle::inline ends {

double wave_speed(const LongWaves& waves, double depth) { return waves.speed(depth); }

double invariant_of_critical_flow(const LongWaves& waves, double going) {
    if (going <= 0.0) return -going;
    if (waves.in_rectangle()) return -going / 3.0;
    const auto surplus = [&](double depth) { return waves.speed(depth) + waves.invariant(depth) - going; };
    const double depth = root_between(surplus, waves.lowest(), waves.depth_of_invariant(going));
    return waves.speed(depth) - waves.invariant(depth);
}

double sequent_depth(const LongWaves& waves, const Section& before) {
    return waves.sequent_depth(before.depth, before.velocity);
}

namespace {

/// As inflow_by_discharge(), in a rectangle.
double depth_in_rectangle(double gravity, double critical, double unit_discharge, double coming) {
    // g q/c^2 - 2 c = coming has one root: the left side falls and is convex, so that Newton's steps rise to
    // it from the second one on.
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
    return c * c / gravity;
}

/// The same in any section.
double depth_in_section(const LongWaves& waves, double unit_discharge, double coming) {
    const auto excess = [&](double depth) {
        return unit_discharge / waves.area(depth) - waves.invariant(depth) - coming;
    };
    if (!(unit_discharge > 0.0)) return waves.depth_of_invariant(-coming);
    const double critical = waves.critical_depth(unit_discharge);
    if (excess(critical) <= 0.0) return critical;
    double rise = critical - waves.lowest();
    while (excess(critical + rise) > 0.0) rise *= 2.0;
    const double high = critical + rise;
    return root_between(excess, critical, high);
}

}  // namespace

Section inflow_by_discharge(const LongWaves& waves, double unit_discharge, double coming) {
    const double depth =
        waves.in_rectangle()
            ? depth_in_rectangle(waves.gravity(), wave_speed(waves, waves.critical_depth(unit_discharge)),
                                 unit_discharge, coming)
            : depth_in_section(waves, unit_discharge, coming);
    return {depth, depth > 0.0 ? unit_discharge / waves.area(depth) : 0.0};
}

Section inflow_by_depth(const LongWaves& waves, double depth, double coming) {
    return {depth, coming + waves.invariant(depth)};
}

double invariant_of_discharge(const LongWaves& waves, const Section& now, double change) {
    return change / (0.5 * waves.area(now.depth) * (1.0 + now.velocity / wave_speed(waves, now.depth)));
}

double invariant_of_depth(const LongWaves& waves, const Section& now, double change) {
    return -2.0 * waves.invariant_by_depth(now.depth) * change;
}

Section outflow_between(const LongWaves& waves, double going, double coming) {
    return {waves.depth_of_invariant(0.5 * (going - coming)), 0.5 * (going + coming)};
}

double relaxation(const LongWaves& waves, const Section& now, double depth, double time, double dt) {
    return 2.0 * waves.invariant_by_depth(now.depth) * (now.depth - depth) * dt / time;
}

}  // namespace riffle::inline ends
