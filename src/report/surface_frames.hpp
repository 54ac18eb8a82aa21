#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "record/run_results.hpp"

namespace riffle::inline report {

/// The free surface in plan, moment by moment: maps of its elevation, the last ones of a run.
struct SurfaceFrames {
    std::vector<double> x;     ///< of the points along the channel, m
    std::vector<double> y;     ///< across it, m
    std::vector<double> time;  ///< s
    std::vector<double>
        elevation;  ///< about the mean of each moment, m; [time][y][x], not-a-number where dry
    bool earlier_left_out = false;  ///< whether the run has more maps than are shown
};

/// The last maps of a results file, at most so many, of at most so many values in all; every second, third,
/// ... point of large maps along and across, so that a moment is followed by a movement and not by one more
/// moment. Nothing where the file has fewer than two maps, or its water has no free surface. Throws FileError
/// where a map does not fit its axes.
[[nodiscard]] std::optional<SurfaceFrames> read_surface_frames(const RunResults& results, const Case& c,
                                                               std::size_t most_values = 400'000,
                                                               std::size_t most_frames = 400);

}  // namespace riffle::inline report
