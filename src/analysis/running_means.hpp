#pragma once

#include <cstddef>
#include <vector>

namespace riffle::inline analysis {

/// Means over `width` samples around each; at the ends over those that there are.
[[nodiscard]] std::vector<double> running_means(const std::vector<double>& values, std::size_t width);

/// The same over a stretch of time (s) of samples at even times, over one sample at least.
[[nodiscard]] std::vector<double> running_means(const std::vector<double>& time,
                                                const std::vector<double>& values, double stretch);

}  // namespace riffle::inline analysis
