#pragma once

#include <filesystem>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline column {

/// A measured velocity profile.
struct VelocityMeasurements {
    std::vector<double> height;       ///< above the bed level, m
    std::vector<double> velocity;     ///< m/s
    std::vector<double> uncertainty;  ///< standard uncertainty of the velocity, m/s; empty: not given
};

/// Read the CSV file `measured.velocity_profile` of the case as read_profile_record does (z above the datum,
/// u and, if there is one, its uncertainty; SI or with units in the header). Throws FileError with file and
/// line if it cannot be read, has no u or misses one, or has a point outside the water.
[[nodiscard]] VelocityMeasurements read_velocity_measurements(const Case& c);

/// Read that file, if the case names one, only to see that it is right: before a run, not after it.
void check_velocity_measurements(const Case& c);

/// The measured rough log law (thesis 2.3) with the case's measured u_* and k_s, at `points` evenly spaced
/// heights between crest and surface: the measured profile to within its fit. Empty unless both are given.
[[nodiscard]] VelocityMeasurements measured_log_law(const Case& c, int points = 10);

}  // namespace riffle::inline column
