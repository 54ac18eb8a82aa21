#pragma once

#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "column/column.hpp"
#include "solver/convergence.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/series.hpp"

namespace riffle {

/// Results of a run as named numbers: the attributes of `/summary` (docs/results-format.md), SI.
struct RunSummary {
    std::vector<std::pair<std::string, double>> values;

    [[nodiscard]] double value(const std::string& name) const;  ///< NaN when absent
    void set(const std::string& name, double value);
};

/// Summarise the averaging window: means with their intervals, friction velocities, departures from the
/// column twin and from the stress line. Velocities are compared at the particles' own heights and relative
/// to the local column velocity; stresses relative to the crest's, without the top three layers, where the
/// kernel is cut.
[[nodiscard]] RunSummary summarise(const Case& c, const ColumnResult* column, const TimeSeries& series,
                                   const Profiles& profiles, const Convergence& convergence);

}  // namespace riffle
