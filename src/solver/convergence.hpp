#pragma once

#include <optional>
#include <span>
#include <string>

#include "statistics/confidence.hpp"

namespace riffle::inline solver {

/// Outcome of the test whether a flow has become statistically steady.
struct Convergence {
    bool converged = false;
    double window_start = 0.0;        ///< of the averaging window, s
    MeanEstimate mean;                ///< of the depth-mean velocity over the window
    MeanEstimate least_known;         ///< of the tested quantity whose interval is widest over its mean
    double remaining_drift = 0.0;     ///< bound of the drift still to come, over the mean, largest of all
    double fluctuation_growth = 0.0;  ///< logarithm of the velocity fluctuation's growth over the window
    double fluctuation_growth_half_width = 0.0;  ///< of its 95 % interval
    std::string reason;                          ///< in words, for the log
};

/// What water enters and leaves, and how much of it there is, between open ends; equally spaced records.
struct EndsRecord {
    std::span<const double> mean_level;         ///< m; empty in ducts
    std::span<const double> outflow_discharge;  ///< of the section there, m2/s or m3/s
    std::span<const double> mass_entered;       ///< so far, kg/m or kg
    std::span<const double> mass_left;          ///< so far, the same unit
    const char* discharge_unit = "m2/s";
};

/// What the test looks at, equally spaced records.
struct SteadinessRecord {
    std::span<const double> time;                  ///< s
    std::span<const double> depth_mean_velocity;   ///< m/s
    std::span<const double> velocity_fluctuation;  ///< rms departure of the particles from their layers, m/s
    std::optional<EndsRecord> ends = {};           ///< of open ends
};

/// Growth of the velocity fluctuation over the averaging window, above which the flow is not what it will be:
/// a quarter.
inline constexpr double largest_fluctuation_growth = 0.25;

/// Test the record of a run. The flow relaxes towards its steady state like exp(-t/T), T the relaxation time
/// of the column twin. The averaging window starts at the first whole T, not before 3 T, from which on (a)
/// the record is at least T long, (b) the trend of the depth-mean velocity, at the far end of its 95 %
/// interval, times T (the drift still to come) is within `tolerance` of the mean, (c) the mean rests on
/// enough independent samples for an interval (fewest_effective_samples), (d) its half-width is within
/// `tolerance` too, correlation taken into account, and (e) the velocity fluctuation has not grown by more
/// than largest_fluctuation_growth, as far as its 95 % interval tells: a growing one says that the order of
/// the start is about to break. Between open ends (T as relaxation_time_between_ends()) the mean level and
/// the discharge of the section at the outflow must pass (b) to (d) too, and (f) the mass that has left
/// during the window must be that which has entered, within `tolerance` of it. `fixed_start` >= 0: the window
/// starts there.
[[nodiscard]] Convergence test_convergence(const SteadinessRecord& record, double relaxation_time,
                                           double tolerance, double fixed_start = -1.0);

/// Relaxation times after which a flow over spheres has usually come to its end: three of start-up, and a
/// record that holds some independent samples.
inline constexpr double usual_relaxation_times = 10.0;

/// About where a run will end that the newest test, at `time`, found not yet converged, s: what is left of
/// the drift falls like exp(-t/T), the standard error of the mean like one over the root of the window, whose
/// independent samples grow with it; usual_relaxation_times before there is a first estimate; at least the
/// record that the test asks for, at most `latest`.
[[nodiscard]] double expected_end(const Convergence& test, double time, double relaxation_time,
                                  double tolerance, double latest);

}  // namespace riffle::inline solver
