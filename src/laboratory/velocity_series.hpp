#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "laboratory/profile_record.hpp"
#include "laboratory/record_repair.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline laboratory {

/// A component of a velocity record.
struct VelocityComponent {
    std::vector<double>
        values;  ///< m/s; empty if the file has none; not a number where no value could be had
    RecordQuality quality;
};

/// Evenly sampled velocities at one point, as of an ADV.
struct VelocitySeries {
    std::filesystem::path source;
    std::string title;
    double x = 0, y = 0, z = 0;     ///< comments "# z: 12 mm"; not a number where the file does not tell
    double start = 0;               ///< time of the first sample, s
    double sampling_frequency = 0;  ///< Hz
    VelocityComponent u, v, w;
    std::vector<CsvComment> comments;
    std::vector<std::string> warnings;
};

struct VelocitySeriesOptions {
    std::optional<double> sampling_frequency;  ///< Hz
    double time_tolerance = 0.1;               ///< of the times, in sampling intervals
    /// Samples whose `correlation` (%) is lower are refused; the usual limit of ADV work. Files without such
    /// a column have none refused.
    double lowest_correlation = 70.0;
    RepairOptions repair;
};

/// Read the velocities at one point: columns `t`, `u` and, if measured, `v`, `w` and `correlation` (%).
/// Missing, refused and despiked samples are counted for each component and told in `warnings`. Throws
/// FileError with line or column.
[[nodiscard]] VelocitySeries read_velocity_series(const std::filesystem::path& path,
                                                  const VelocitySeriesOptions& options = {});

/// Statistics of the velocities at a point with 95 % intervals that take the correlation of successive
/// samples into account (statistics/moments.hpp). Each is over the samples that have its components; those
/// that were not measured are not numbers. InputError for fewer than two samples.
struct PointStatistics {
    std::size_t samples = 0;  ///< with a value of u
    Estimate u, v, w;
    Estimate u_rms, v_rms, w_rms;
    Estimate reynolds_stress;  ///< -u'w', m2/s2
};
[[nodiscard]] PointStatistics point_statistics(const VelocitySeries& series);

/// The profile of the statistics of several points, by rising height: the same as read_profile_record gives
/// of a file of profiles. Throws InputError if a point has no height or two have the same.
[[nodiscard]] ProfileRecord profile_of_series(std::span<const VelocitySeries> series);

}  // namespace riffle::inline laboratory
