#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"

namespace riffle::inline analysis {

/// The findings of an analysis as text for a terminal, chapter by chapter: value, half-width of the 95 %
/// interval, reference and relative difference; remarks below their line; warnings and figures without data
/// at the end.
[[nodiscard]] std::string analysis_to_text(const Analysis& analysis);

/// The findings of several analyses side by side, one line per finding that at least two of them have.
[[nodiscard]] std::string comparison_to_text(const std::vector<Analysis>& analyses);

}  // namespace riffle::inline analysis
