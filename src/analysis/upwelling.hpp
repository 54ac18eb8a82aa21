#pragma once

#include <cstddef>

#include "analysis/space_time.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

// Upwellings and downwellings: where water rises to the surface and sinks from it. Tamburrino & Gulliver
// (1999; thesis 2.30-2.31) expect about A_r/2 of each across a channel of aspect ratio A_r = width/depth. The
// sources give no threshold. The definition used here: an upwelling is a stretch of the line on which w' > 0
// throughout and somewhere above a threshold, a downwelling the same with -w'. The sign alone would count
// every ripple of noise about zero, a threshold alone would count one event with a dent at its level twice;
// together an event begins and ends where the motion does.

/// Numbers of events on the line at a time.
struct UpwellingCounts {
    MeanEstimate upwellings, downwellings;  ///< with 95 % intervals, the correlation in time accounted for
    /// Mean numbers per stretch of the length of one water depth.
    double upwellings_per_depth = 0.0, downwellings_per_depth = 0.0;
    double threshold = 0.0;  ///< that was used, m/s
};

/// Counts from w'(x, t) (m/s, mean zero) on a line at one height, best 0.1-0.2 depths under the surface:
/// waves move the water there, too, and count where they are stronger than turbulence. `threshold` in
/// standard deviations of the whole record. A stretch ends at the ends of the line and at dry points, not
/// where a periodic line closes. Throws InputError for a negative threshold or a depth (m) that is not
/// positive.
[[nodiscard]] UpwellingCounts count_upwellings(const SpaceTime& vertical_velocity, double depth,
                                               double threshold = 0.5);

/// The vertical velocity of the surface itself, d eta/dt + u_s d eta/dx (kinematic condition, m/s), from its
/// elevation and velocity u_s (m/s) where no velocity under it was recorded: central differences, one-sided
/// at the ends; not-a-number beside dry points. Short waves count in it more than under the surface. Needs
/// three times (else InputError).
[[nodiscard]] SpaceTime surface_vertical_velocity(const SpaceTime& elevation, double surface_velocity);

/// Number of upwellings expected across a channel, as many of downwellings: A_r/2 (thesis 2.30-2.31).
[[nodiscard]] constexpr double expected_upwellings(double width, double depth) { return 0.5 * width / depth; }

}  // namespace riffle::inline analysis
