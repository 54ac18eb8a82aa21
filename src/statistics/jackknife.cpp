#include "statistics/jackknife.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace riffle::inline statistics {

double jackknife_half_width(std::span<const double> without_one) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (without_one.size() < 2) return infinity;
    const auto n = static_cast<double>(without_one.size());
    const double mean = std::accumulate(without_one.begin(), without_one.end(), 0.0) / n;
    if (!std::isfinite(mean)) return infinity;
    double sum = 0.0;
    for (const double v : without_one) sum += (v - mean) * (v - mean);
    const boost::math::students_t distribution(n - 1.0);
    return boost::math::quantile(boost::math::complement(distribution, 0.025)) *
           std::sqrt((n - 1.0) / n * sum);
}

std::vector<double> mean_without(std::span<const double> blocks, std::size_t width, std::size_t left_out) {
    std::vector<double> sum(width, 0.0);
    std::vector<double> count(width, 0.0);
    for (std::size_t n = 0; n < blocks.size(); ++n) {
        if (n / width == left_out || std::isnan(blocks[n])) continue;
        sum[n % width] += blocks[n];
        count[n % width] += 1.0;
    }
    for (std::size_t i = 0; i < width; ++i) sum[i] /= count[i];
    return sum;
}

}  // namespace riffle::inline statistics
