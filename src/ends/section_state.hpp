#pragma once

namespace riffle::inline ends {

// The state of the water over a section at an open end, from the characteristics of shallow water: along
// dx/dt = U + c goes U + 2 c, along dx/dt = U - c goes U - 2 c, c = sqrt(g h) (Henderson 1966, chapter 8).

/// Depth (m, of the whole water) and depth-mean velocity (m/s) of a section.
struct Section {
    double depth = 0.0;
    double velocity = 0.0;
};

/// Speed of long waves, m/s.
[[nodiscard]] double wave_speed(double gravity, double depth);

/// Invariant U - 2 c of critical flow, U = c, in which U + 2 c = `going`, m/s; where that runs back, the one
/// with which nothing moves.
[[nodiscard]] double invariant_of_critical_flow(double going);

/// Depth behind a jump from a section, m: where the momentum function is the same (Bélanger).
[[nodiscard]] double sequent_depth(double gravity, const Section& before);

/// Subcritical section at the upstream end with a discharge (m2/s), where the invariant U - 2 c = `coming`
/// comes up the channel. Not shallower than critical flow: below that nothing comes up.
[[nodiscard]] Section inflow_by_discharge(double gravity, double unit_discharge, double coming);

/// The same with a depth.
[[nodiscard]] Section inflow_by_depth(double gravity, double depth, double coming);

/// Change of the invariant `going` = U + 2 c, which enters at the upstream end, that changes the discharge of
/// a section by `change` (m2/s). Where it brings the discharge home within a time, what is thrown back of a
/// wave of the period T is (1 - Fr)/(1 + Fr)/sqrt(1 + (2 pi time/T)^2) of its height.
[[nodiscard]] double invariant_of_discharge(double gravity, const Section& now, double change);

/// Change of the invariant `coming` = U - 2 c, which enters at the downstream end, that changes the depth of
/// a section by `change` (m).
[[nodiscard]] double invariant_of_depth(double gravity, const Section& now, double change);

/// Section at the downstream end between the invariants `going` = U + 2 c, which comes down the channel, and
/// `coming` = U - 2 c, which enters there.
[[nodiscard]] Section outflow_between(double gravity, double going, double coming);

/// Change of the invariant `coming` in dt (s) that brings the depth of the outflow to `depth` within the
/// relaxation time (s): dR/dt = 2 sqrt(g/h) (h - depth)/time. Of a wave of the period T it throws back
/// 1/sqrt(1 + (2 pi time/T)^2) of its height.
[[nodiscard]] double relaxation(double gravity, const Section& now, double depth, double time, double dt);

}  // namespace riffle::inline ends
