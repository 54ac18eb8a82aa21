#pragma once

#include <string>
#include <vector>

#include "case/outline.hpp"
#include "record/run_results.hpp"

namespace riffle::inline report {

/// Outlines in which the plane at y cuts the solids of a run in three dimensions, from /boundaries/solids of
/// its results, at the time of a snapshot. Empty for files without them.
[[nodiscard]] std::vector<Outline> solid_cuts(const RunResults& results, const std::string& snapshot,
                                              double y);

}  // namespace riffle::inline report
