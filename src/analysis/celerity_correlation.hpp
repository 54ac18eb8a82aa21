#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/space_time.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline analysis {

/// Temporal cross-correlation between stations a distance apart (thesis 4.7), over all pairs of columns at
/// that distance: R(t_l) = <h'_m(t) h'_n(t + t_l)> / sqrt(<h'_m^2> <h'_n^2>), n downstream of m, each mean
/// over the samples that the lag leaves.
struct StationCorrelation {
    double distance = 0.0;            ///< m
    std::vector<double> lag;          ///< s, from the most negative
    std::vector<double> correlation;  ///< R
    /// The extreme that belongs to the passing patterns; not-a-number with an infinite interval where none is
    /// found.
    Estimate extreme_lag;              ///< s
    double extreme_correlation = 0.0;  ///< negative for a minimum
};

/// How stations are compared.
struct StationOptions {
    double largest_distance = 0.0;  ///< m; 0: half of the line
    std::size_t distances = 12;     ///< at most so many, evenly spread
    double largest_lag = 0.0;       ///< s; 0, and at most: half of a block
    /// The sequence ends where |R| of the extreme falls below this.
    double smallest_correlation = 0.3;
    std::size_t blocks = 10;  ///< of time, for the interval
};

/// Celerity from the lags of extremes.
struct StationCelerity {
    /// Slope of x_l = U t_l through the origin over the distances whose extreme was found, least squares of
    /// the lags weighted by R^2; interval by the jackknife over blocks of time, and what parabolas through
    /// every second lag change. Not-a-number where no lag was found.
    Estimate celerity;
    std::vector<StationCorrelation> stations;  ///< by distance; the first is a station with itself
    std::size_t used = 0;                      ///< distances, from the shortest on
};

/// The velocity at which what one station sees arrives at the next, over the distances and times that
/// patterns live: that of the mean pattern, dominated by the large ones. Beginning with the nearest stations,
/// the extreme of R (maximum, or minimum where patterns change sign on the way as Horoshenkov's do) is looked
/// for within a third of the record's own oscillation of where the distances before put it; so neighbouring
/// patterns (aliases) are not mistaken for it as long as the first distance is short beside them. Around a
/// periodic channel a pattern also arrives after length/celerity: distances end at half the length.
/// `fluctuation`: mean zero, even times. Throws InputError for dry points or blocks of less than 16 times.
[[nodiscard]] StationCelerity station_celerity(const SpaceTime& fluctuation,
                                               const StationOptions& options = {});

/// The same of a few stations at uneven places, such as wave probes, sampled at `interval` (s): every pair is
/// a distance of its own, those up to `largest_distance` are used (0: all), `distances` is not. Each record
/// is less its mean and over its own deviation, as (4.7) is printed. The nearest two stations must be closer
/// than half a pattern. Throws InputError as above, and for fewer than two stations or records of different
/// lengths.
[[nodiscard]] StationCelerity station_celerity(std::span<const StationRecord> stations, double interval,
                                               const StationOptions& options = {});

}  // namespace riffle::inline analysis
