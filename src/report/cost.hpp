#pragma once

#include <string>
#include <vector>

#include "report/comparison.hpp"

namespace riffle::inline report {

/// A row of the table of costs: texts, one for each run; "–" where a value is not known.
struct CostRow {
    std::string key;
    std::string label;
    std::vector<std::string> values;
};

/// What the runs of a comparison cost: particles, steps, computing time, and that per simulated second beside
/// the thesis' own runs of the flow condition in as many dimensions (one core of an i7-4770; 130 s in two and
/// 6 s in three dimensions). Empty where no run is in three dimensions, or none says.
[[nodiscard]] std::vector<CostRow> cost_rows(const std::vector<ComparedRun>& runs);

}  // namespace riffle::inline report
