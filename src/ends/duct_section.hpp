#pragma once

namespace riffle::inline ends {

// The state of the water over a section of a duct, from the characteristics of sound: with the water goes
// U + p/(rho c0), against it comes U - p/(rho c0). Pressures are divided by the density.

/// Mean velocity (m/s) and pressure (m2/s2) of a section.
struct DuctSection {
    double velocity = 0.0;
    double pressure = 0.0;
};

/// Section between the invariants `going` = U + p/(rho c0) and `coming` = U - p/(rho c0).
[[nodiscard]] DuctSection duct_section(double sound_speed, double going, double coming);

/// Section at the inflow after dt (s), where `coming` comes out of the duct: its velocity goes to `wanted`,
/// which has changed by `change` in dt, within a relaxation time (s). Sound of the period T is thrown back by
/// 1/sqrt(1 + (2 pi time/T)^2) of its pressure; with a time of 0, where the velocity holds at each moment,
/// all of it.
[[nodiscard]] DuctSection duct_inflow(double sound_speed, const DuctSection& now, double coming,
                                      double wanted, double change, double time, double dt);

/// Change of the invariant `coming` in dt (s) that brings the pressure of the outflow to `pressure` within a
/// relaxation time (s); of sound as much comes back as from duct_inflow().
[[nodiscard]] double duct_relaxation(double sound_speed, const DuctSection& now, double pressure, double time,
                                     double dt);

}  // namespace riffle::inline ends
