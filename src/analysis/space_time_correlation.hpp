#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/space_time.hpp"

namespace riffle::inline analysis {

/// How far apart in space and time places are correlated.
struct CorrelationReach {
    double step = 0.0;  ///< between distances, m; the nearest multiple of the spacing, at least one
    double largest_distance = 0.0;  ///< m; 0: the whole line, half of it where it closes on itself
    double largest_lag = 0.0;       ///< s; 0: a quarter of the record
};

/// Temporal cross-correlation of a quantity along a line between places a distance apart, the later record
/// that of the place downstream: R(distance, lag) = <a'(x, t) a'(x + distance, t + lag)> over the standard
/// deviations of both records (thesis 4.7, 4.8), mean over all pairs of places at that distance.
struct SpaceTimeCorrelation {
    std::vector<double> distance;     ///< from 0, m
    std::vector<double> lag;          ///< from 0, s
    std::vector<double> correlation;  ///< [d * lag.size() + k]

    [[nodiscard]] std::span<const double> of(std::size_t d) const {
        return std::span(correlation).subspan(d * lag.size(), lag.size());
    }
};

/// Of records at even times, whose means are taken away here; for each lag over the samples that it leaves.
/// Along a line that closes on itself a distance beyond half of it is one that a pattern has travelled, too.
/// Throws InputError for dry points, uneven times, a constant record or fewer than two places.
[[nodiscard]] SpaceTimeCorrelation space_time_correlation(const SpaceTime& data,
                                                          const CorrelationReach& reach = {});

/// The extreme (maximum or minimum of the largest size) of a temporal cross-correlation over its lags, the
/// first and last included, since at distance 0 it lies at lag 0.
struct LagExtreme {
    double lag = 0.0;  ///< s
    double correlation = 0.0;
};
[[nodiscard]] LagExtreme extreme_over_lag(const SpaceTimeCorrelation& correlation, std::size_t d,
                                          double largest_lag);

/// The thesis' correlation of the vertical velocity at one height (4.8): the extreme over the lag between
/// places along the stream, against their distance.
struct StreamwiseCorrelation {
    double z = 0.0;                ///< m above the bed level
    std::vector<double> distance;  ///< m
    std::vector<double> extreme;
    std::vector<double> lag;     ///< of the extreme, s
    std::optional<double> zero;  ///< first distance at which the extreme passes through zero, m
};

/// Of w'(x, t) at one height. `velocity` (m/s) bounds the lag: twice the time that the water takes to the
/// place; without one (0) a quarter of the record does. `significance`: what the size of an extreme after the
/// first change of sign must reach at the least, so that the change is none of unrelated records.
[[nodiscard]] StreamwiseCorrelation streamwise_correlation(double z, const SpaceTime& vertical_velocity,
                                                           const CorrelationReach& reach, double velocity,
                                                           double significance);

/// The thesis' influence depth of the surface: going down from the highest of the heights, the last one at
/// which the correlation still passes through zero within the distances, m above the bed level. None where it
/// does not at the highest.
[[nodiscard]] std::optional<double> deepest_zero(std::span<const StreamwiseCorrelation> heights);

}  // namespace riffle::inline analysis
