#pragma once

#include "ends/long_waves.hpp"

namespace riffle::inline ends {

// The state of the water over a section at an open end, from the characteristics of shallow water
// (LongWaves): in a rectangle, along dx/dt = U + c goes U + 2 c, along dx/dt = U - c goes U - 2 c, c = sqrt(g
// h) (Henderson 1966, chapter 8). `waves`: those of the cross-section; of a rectangle the gravity alone.
// Discharges are those over the width of the channel.

/// Depth (m, of the whole water) and mean velocity (m/s) of a section.
struct Section {
    double depth = 0.0;
    double velocity = 0.0;
};

/// Speed of long waves, m/s.
[[nodiscard]] double wave_speed(const LongWaves& waves, double depth);

/// Invariant U - 2 c of critical flow, U = c, in which U + 2 c = `going`, m/s; where that runs back, the one
/// with which nothing moves.
[[nodiscard]] double invariant_of_critical_flow(const LongWaves& waves, double going);

/// Depth behind a jump from a section, m: where the momentum function is the same (Bélanger).
[[nodiscard]] double sequent_depth(const LongWaves& waves, const Section& before);

/// Subcritical section at the upstream end with a discharge (m2/s), where the invariant U - 2 c = `coming`
/// comes up the channel. Not shallower than critical flow: below that nothing comes up.
[[nodiscard]] Section inflow_by_discharge(const LongWaves& waves, double unit_discharge, double coming);

/// The same with a depth.
[[nodiscard]] Section inflow_by_depth(const LongWaves& waves, double depth, double coming);

/// Change of the invariant `going` = U + 2 c, which enters at the upstream end, that changes the discharge of
/// a section by `change` (m2/s). Where it brings the discharge home within a time, what is thrown back of a
/// wave of the period T is (1 - Fr)/(1 + Fr)/sqrt(1 + (2 pi time/T)^2) of its height.
[[nodiscard]] double invariant_of_discharge(const LongWaves& waves, const Section& now, double change);

/// Change of the invariant `coming` = U - 2 c, which enters at the downstream end, that changes the depth of
/// a section by `change` (m).
[[nodiscard]] double invariant_of_depth(const LongWaves& waves, const Section& now, double change);

/// Section at the downstream end between the invariants `going` = U + 2 c, which comes down the channel, and
/// `coming` = U - 2 c, which enters there.
[[nodiscard]] Section outflow_between(const LongWaves& waves, double going, double coming);

/// Change of the invariant `coming` in dt (s) that brings the depth of the outflow to `depth` within the
/// relaxation time (s): dR/dt = 2 sqrt(g/h) (h - depth)/time. Of a wave of the period T it throws back
/// 1/sqrt(1 + (2 pi time/T)^2) of its height.
[[nodiscard]] double relaxation(const LongWaves& waves, const Section& now, double depth, double time,
                                double dt);

}  // namespace riffle::inline ends
