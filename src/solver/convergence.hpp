#pragma once

#include <span>
#include <string>

#include "statistics/confidence.hpp"

namespace riffle {

/// Outcome of the test whether a flow has become statistically steady.
struct Convergence {
    bool converged = false;
    double window_start = 0.0;     ///< of the averaging window, s
    MeanEstimate mean;             ///< of the depth-mean velocity over the window
    double remaining_drift = 0.0;  ///< bound of the drift still to come, over the mean
    std::string reason;            ///< in words, for the log
};

/// Test the record of the depth-mean velocity. The flow relaxes towards its steady state like exp(-t/T), T
/// the relaxation time of the column twin. The averaging window starts at the first whole T, not before 3 T,
/// from which on (a) the record is at least T long, (b) the trend, at the far end of its 95 % interval, times
/// T (the drift still to come) is within `tolerance` of the mean, and (c) so is the half-width of the mean's
/// 95 % interval, correlation taken into account. `time`, `velocity`: equally spaced record. `fixed_start` >=
/// 0: the window starts there.
[[nodiscard]] Convergence test_convergence(std::span<const double> time, std::span<const double> velocity,
                                           double relaxation_time, double tolerance,
                                           double fixed_start = -1.0);

}  // namespace riffle
