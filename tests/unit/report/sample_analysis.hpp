#pragma once

#include <string>

#include "analysis/figure.hpp"

namespace riffle::testing {

/// An analysis with every kind of figure that the contract knows: curves of each origin and mark, intervals
/// on both axes, gaps, logarithmic axes, maps of each colour scale with curves over them, a figure without
/// data, findings with and without references. `scale` changes the numbers a little, so that runs can be told
/// apart.
[[nodiscard]] Analysis sample_analysis(const std::string& name, double scale = 1.0);

/// A laboratory record: measured curves of some of the figures of sample_analysis.
[[nodiscard]] Analysis sample_record(const std::string& name);

}  // namespace riffle::testing
