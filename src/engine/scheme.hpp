#pragma once

#include "case/case.hpp"
#include "column/column.hpp"
#include "sph/equation_of_state.hpp"

namespace riffle::inline engine {

/// Numbers of a run that follow from its case: sizes, sound speed, time step. SI.
struct Scheme {
    double spacing = 0.0;           ///< lattice spacing along x
    double smoothing_length = 0.0;  ///< h
    double depth = 0.0;             ///< total depth H
    double maximum_velocity = 0.0;  ///< expected, sets the sound speed
    StateEquation state;
    double density = 0.0;         ///< rho0
    double viscosity = 0.0;       ///< nu0
    double bulk_viscosity = 0.0;  ///< against sound, zeta/rho0, m2/s
    double streamwise_gravity = 0.0;
    double normal_gravity = 0.0;
    double acoustic_step = 0.0;  ///< Courant number * h / c0

    /// Density deviation of still water at height z: the hydrostatic pressure through the equation of state.
    [[nodiscard]] double hydrostatic_deviation(double z) const;
};

/// Derive the scheme; `column` is the twin of the case where it has one (nullptr: no steady shear flow).
[[nodiscard]] Scheme make_scheme(const Case& c, const ColumnResult* column);

/// Bound of the time step of a run, s: the fixed step, or that of the Courant number and the viscosity.
[[nodiscard]] double largest_step(const Case& c, const Scheme& scheme);

/// Each which step the leapfrog takes its continuity sum in the middle of the way: the second of flow in
/// layers along a channel, each one around bodies, between end walls, over the end of a bed, with resolved
/// eddies and impacts.
[[nodiscard]] int midway_interval(const Case& c);

/// Step by the largest acceleration: 0.25 sqrt(h/|a|) (Monaghan & Kos 1999; thesis 2.53).
[[nodiscard]] double force_limited_step(const Scheme& scheme, double largest_acceleration);

/// Step of Monaghan & Kos (1999; thesis 2.53): C min(sqrt(h/a), h/(c0 + approach)), s, from the largest
/// acceleration a (m/s2) and the largest velocity of a pair along its line of centres (m/s).
[[nodiscard]] double monaghan_kos_step(const Scheme& scheme, double courant_number,
                                       double largest_acceleration, double approach);

}  // namespace riffle::inline engine
