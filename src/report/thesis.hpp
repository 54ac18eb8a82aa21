#pragma once

#include <vector>

#include "report/comparison.hpp"

namespace riffle {

/// The thesis' 2D chapter from finished runs: the seven flow conditions side by side, the closure against the
/// original SPS model, the spacings, and the case of the 2016 paper. Runs are known by their case, not by
/// their folder's name; what is not among them is listed in `missing` with the command that makes it. Throws
/// as compare does.
[[nodiscard]] Comparison thesis_chapter(const std::vector<ReportSubject>& subjects);

}  // namespace riffle
