#pragma once

#include <cstddef>
#include <vector>

#include "analysis/space_time.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline analysis {

/// One crest followed through the space-time map.
struct CrestTrack {
    std::vector<double> times;      ///< s
    std::vector<double> positions;  ///< m; beyond the ends of a periodic line the count goes on
    /// Of each position by the parabola through the crest's second neighbours instead of the first, m.
    std::vector<double> shifts;
    double celerity = 0.0;  ///< slope of the track, m/s
};

/// How crests are found and followed.
struct CrestOptions {
    double expected_celerity = 0.0;  ///< m/s; where a crest is looked for at the next time
    /// Half the width of the stretch it is looked for in, m; 0: a quarter of the mean distance of crests, at
    /// least 1.5 spacings.
    double search_distance = 0.0;
    /// Standard deviation of the Gaussian that smooths each time along the line, m: against white noise,
    /// whose own crests do not travel. 0: none. A fifth of L0 halves what the smallest patterns carry.
    double smoothing = 0.0;
    double smallest_height = 0.5;   ///< of a crest above the mean, in standard deviations
    std::size_t smallest_rows = 6;  ///< that a track must last
    std::size_t blocks = 10;        ///< of time, for the interval
};

/// Celerity of crests.
struct CrestCelerity {
    /// Mean of the tracks' slopes, weighted by their duration, those far from the median counting less (Huber
    /// 1964); interval by the jackknife over blocks of time, and the error of the parabolas. Not-a-number
    /// without tracks.
    Estimate celerity;
    double scatter = 0.0;  ///< standard deviation of the slopes from their quartiles, m/s
    std::vector<CrestTrack> tracks;
};

/// Follow crests and fit a line to each track: its slope is the median of the slopes between its points
/// (Theil 1950, Sen 1968), which a few wrong links do not move; of a line that is not periodic without the
/// first and the last point, which noise keeps from being found beyond the ends. It measures the phase speed
/// of crests while they live, so the short steep ones weigh as much as the long; where waves of several kinds
/// cross, that of the most numerous. A crest is linked only within the search distance of where the expected
/// celerity puts it: the found celerity cannot be further from the expected one than that distance over the
/// interval, and where crests move by half their distance from one time to the next (coarse sampling, a short
/// periodic channel), a crest cannot be told from its neighbour. `fluctuation`: mean zero, even times. Throws
/// InputError for fewer rows than blocks or a negative length.
[[nodiscard]] CrestCelerity track_crests(const SpaceTime& fluctuation, const CrestOptions& options);

}  // namespace riffle::inline analysis
