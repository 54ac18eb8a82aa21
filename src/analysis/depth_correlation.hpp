#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "statistics/cross_correlation.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline analysis {

/// A record at one height, evenly sampled; not-a-number where there was no water.
struct HeightRecord {
    double z = 0.0;  ///< m above the bed level
    std::vector<double> values;
};

/// The correlation of w' at one height with a reference.
struct HeightCorrelation {
    double z = 0.0;           ///< m
    Estimate correlation;     ///< at the same time, with its 95 % interval
    CrossCorrelation lagged;  ///< over the lag (thesis 4.8); a positive lag: the height follows the reference
    /// The maximum or minimum of the largest size over the lags; none where there is no extreme.
    std::optional<CorrelationExtreme> extreme;
};

/// Correlation of w' over depth with a reference at the same x: w' at a reference height, or the surface (its
/// elevation, which leads and lags w' by a quarter of a wave's period, or better its vertical velocity).
/// Heights whose record is constant are left out. `interval` and `largest_lag` in s. Throws InputError where
/// the records differ in length or the interval is not positive.
[[nodiscard]] std::vector<HeightCorrelation> depth_correlation(
    std::span<const HeightRecord> vertical_velocity, std::span<const double> reference, double interval,
    double largest_lag);

/// How deep the reference's motion reaches.
struct InfluenceDepth {
    double z = 0.0;  ///< height where the correlation falls through the threshold, m
    /// Heights where the correlation less and plus its half-width do: the 95 % interval. Not-a-number where
    /// that does not happen within the records.
    double lower = 0.0, upper = 0.0;
};

/// The height, going down from `from` (m), where the correlation at the same time falls through `threshold`,
/// between two heights linearly; 0.5, a quarter of the variance explained, unless told otherwise. The thesis
/// measures the influence depth otherwise: deepest_zero() (space_time_correlation.hpp). None where the
/// correlation is below the threshold from the start, or nowhere.
[[nodiscard]] std::optional<InfluenceDepth> influence_depth(std::span<const HeightCorrelation> correlations,
                                                            double from, double threshold = 0.5);

}  // namespace riffle::inline analysis
