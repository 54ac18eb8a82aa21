#pragma once

#include <vector>

namespace riffle::inline analysis {

/// Means over a stretch of time (s) around each of samples at even times, over one sample at least; at the
/// ends over those that there are.
[[nodiscard]] std::vector<double> running_means(const std::vector<double>& time,
                                                const std::vector<double>& values, double stretch);

}  // namespace riffle::inline analysis
