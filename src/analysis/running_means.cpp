#include "analysis/running_means.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace riffle::inline analysis {

std::vector<double> running_means(const std::vector<double>& time, const std::vector<double>& values,
                                  double stretch) {
    if (time.size() < 2) return values;
    const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    const auto width = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(stretch / interval)));
    std::vector<double> sums(values.size() + 1, 0.0);
    std::partial_sum(values.begin(), values.end(), sums.begin() + 1);
    std::vector<double> means(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t first = i - std::min(i, width / 2);
        const std::size_t last = std::min(values.size(), i + width - width / 2);
        means[i] = (sums[last] - sums[first]) / static_cast<double>(last - first);
    }
    return means;
}

}  // namespace riffle::inline analysis
