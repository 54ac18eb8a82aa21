#pragma once

#include "analysis/run_record.hpp"
#include "record/numbers.hpp"

namespace riffle::inline analysis {

/// The summary of a run, the attributes of `/summary`, over the window of a record, where that is another one
/// than the run's own. Without what the test of convergence found, which looked at the run's own.
[[nodiscard]] Numbers window_summary(const RunRecord& record);

}  // namespace riffle::inline analysis
