#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/space_time.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline analysis {

/// The spatial correlation of a fluctuation, W(rho) = <eta'(x) eta'(x + rho)> / <eta'^2>, over all pairs of
/// points at a distance and all times.
struct SpatialCorrelation {
    std::vector<double> distance;     ///< from 0 up, m
    std::vector<double> correlation;  ///< 1 at zero
    std::vector<double> half_width;   ///< of the 95 % intervals, by the jackknife over blocks of time
    std::optional<double> period;     ///< of a periodic line, m
    /// The shortest L0 that these distances show, m: four spacings of a line (below, its values are those of
    /// neighbouring points), twice the least distance of stations.
    double shortest_period = 0.0;
    std::size_t blocks = 0;
    std::vector<double> block_covariance;  ///< [block * distance.size() + lag], m2
};

/// Distances to `largest_distance` (m; at most half a period, else length - spacing). The pairs around a
/// periodic line count. No mean is removed: take the fluctuation() first. Dry points are left out. The blocks
/// of time must be long beside the life or the passage of a pattern: a pattern that circles unchanged in a
/// periodic channel is one sample however long it is watched, and no interval from one run tells that.
/// Throws InputError for fewer rows than two per block or no distance beyond zero.
[[nodiscard]] SpatialCorrelation spatial_correlation(const SpaceTime& fluctuation, double largest_distance,
                                                     std::size_t blocks = 10);

/// The same of a few stations at uneven places, such as wave probes: zero and the distances of all pairs,
/// each with its own <eta'_m eta'_n>/sqrt(<eta'_m^2> <eta'_n^2>), the means removed. Throws InputError for
/// fewer than two stations, records of different lengths, a record without variance, or fewer samples than
/// two per block.
[[nodiscard]] SpatialCorrelation spatial_correlation(std::span<const StationRecord> stations,
                                                     std::size_t blocks = 10);

/// Horoshenkov's function (Horoshenkov, Nichols, Tait & Maximov 2013; thesis 2.32), no factor 2 in the
/// exponent: exp(-rho^2/sigma_w^2) cos(2 pi rho/L0).
[[nodiscard]] double horoshenkov_correlation(double rho, double characteristic_period,
                                             double correlation_radius);

/// The same along a line that closes on itself after `period` (m): summed over the images a period away and
/// divided by its value at zero. Without a period the function itself.
[[nodiscard]] double horoshenkov_correlation(double rho, double characteristic_period,
                                             double correlation_radius, const std::optional<double>& period);

/// The function fitted to a spatial correlation.
struct SurfaceCorrelationFit {
    Estimate characteristic_period;  ///< L0, m
    Estimate correlation_radius;     ///< sigma_w, m
    /// Share of the variance that the function describes: 1 where no white noise was allowed for.
    Estimate correlated_share;
    double residual = 0.0;  ///< root mean square of W less the fit
};

/// How the function is fitted.
struct SurfaceCorrelationOptions {
    /// Allow for white noise of each point (probes; the detection of a surface from particles): the function
    /// times a free share is fitted to the distances beyond zero. Otherwise the share is 1.
    bool white_noise = true;
};

/// Least squares over the distances with equal weights, from the best of a table of starts. Of a periodic
/// line the function is summed over its images a period away and divided by its value at zero. The residuals
/// at neighbouring distances are correlated, so the intervals do not come from their scatter but from fits to
/// the correlation without one block of time each (jackknife). They do not contain what the removal of a mean
/// does on a line of few patterns. L0 beyond twice the largest distance or below the shortest that the
/// distances show, sigma_w beyond four times the largest distance or below a thousandth, and a share at a
/// bound (0.001, 1.2) are not determined: not-a-number with infinite intervals then, and where the fit does
/// not converge.
[[nodiscard]] SurfaceCorrelationFit fit_surface_correlation(const SpatialCorrelation& correlation,
                                                            const SurfaceCorrelationOptions& options = {});

}  // namespace riffle::inline analysis
