#pragma once

#include <vector>

#include "analysis/flow_record.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline analysis {

/// Statistics of the velocities recorded at one point, with 95 % intervals that take correlation in time into
/// account. SI.
struct ProbePointStatistics {
    std::size_t point = 0;  ///< of the probe
    double x = 0;
    double y = 0;                  ///< across the channel, m; 0 where it is not known
    double z = 0;                  ///< above the bed level, m
    Estimate u, v, w;              ///< means
    Estimate u_rms, v_rms, w_rms;  ///< standard deviations
    Estimate uw;                   ///< covariance <u'w'>
    Estimate u_skewness, w_skewness;
    double integral_time = 0;    ///< of u', to the first zero crossing of its autocorrelation, s
    double integral_length = 0;  ///< by Taylor's hypothesis, mean u times the time, m
    std::size_t samples = 0;     ///< that are there
};

/// The points of a probe that have at least `fewest` samples, from the bed up. The members of
/// components that the probe does not have are zero.
[[nodiscard]] std::vector<ProbePointStatistics> probe_point_statistics(const VelocityProbe& probe,
                                                                       std::size_t fewest = 32);

/// The sampling interval of a probe, s: the mean one.
[[nodiscard]] double sampling_interval_of(const VelocityProbe& probe);

}  // namespace riffle::inline analysis
