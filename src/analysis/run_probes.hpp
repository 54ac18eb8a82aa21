#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow_record.hpp"
#include "record/run_results.hpp"

namespace riffle::inline analysis {

/// The instruments of a run, from the groups `/probes/NAME` of its results file (docs/results-format.md),
/// over the window. Instruments share `most_values` equally; one with more values than that keeps its last
/// ones, which `warnings` then says. Throws FileError where arrays do not fit each other.
struct RunProbes {
    std::vector<ElevationProbe> wave;
    std::vector<VelocityProbe> velocity;
    std::vector<VelocityGrid> grids;
    std::vector<VelocityPlane> planes;
    std::vector<ScalarProbe> scalars;
    SpaceTime surface_line;  ///< of the surface line with the most points; without rows if there is none
    std::vector<std::string> warnings;
};
[[nodiscard]] RunProbes read_probes(const RunResults& results, const Case& c, const TimeWindow& window,
                                    std::size_t most_values);

/// Length after which the channel of a case repeats, m; none between walls.
[[nodiscard]] std::optional<double> period_of(const Case& c);

}  // namespace riffle::inline analysis
