#include "statistics/stationarity.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/binomial.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

namespace {

constexpr std::size_t smallest_record = 10;
constexpr std::size_t fewest_blocks = 10;
constexpr std::size_t most_blocks = 40;
/// Means of neighbouring blocks of 20 integral scales of an exponential correlation are correlated by 1/40.
constexpr double scales_per_block = 20.0;

/// Chances of 0, 1, 2 ... reverse arrangements of n numbers in random order: those of n - 1 numbers, to which
/// the n-th adds 0 to n - 1 with equal chance.
std::vector<double> arrangements_distribution(std::size_t n) {
    std::vector<double> chance{1.0};
    for (std::size_t m = 2; m <= n; ++m) {
        std::vector<double> next(chance.size() + m - 1, 0.0);
        double sum = 0.0;
        for (std::size_t k = 0; k < next.size(); ++k) {
            if (k < chance.size()) sum += chance[k];
            if (k >= m) sum -= chance[k - m];
            next[k] = std::max(sum, 0.0) / static_cast<double>(m);
        }
        chance = std::move(next);
    }
    return chance;
}

double binomial(std::size_t n, std::size_t k) {
    if (k > n) return 0.0;
    return boost::math::binomial_coefficient<double>(static_cast<unsigned>(n), static_cast<unsigned>(k));
}

/// Chance of `runs` runs of a numbers of one kind and b of another in random order.
double runs_chance(std::size_t runs, std::size_t a, std::size_t b) {
    const std::size_t k = runs / 2;
    const double all = binomial(a + b, a);
    if (runs % 2 == 0) return 2.0 * binomial(a - 1, k - 1) * binomial(b - 1, k - 1) / all;
    return (binomial(a - 1, k - 1) * binomial(b - 1, k) + binomial(a - 1, k) * binomial(b - 1, k - 1)) / all;
}

double two_sided_p_value(const TrendEstimate& trend) {
    if (!(trend.standard_error > 0.0)) return trend.slope == 0.0 ? 1.0 : 0.0;
    const boost::math::students_t distribution(std::max(trend.effective_samples - 2.0, 1.0));
    return 2.0 * cdf(complement(distribution, std::abs(trend.slope) / trend.standard_error));
}

/// The record without its linear trend, of zero mean.
std::vector<double> without_trend(std::span<const double> record, double slope) {
    const double mean = mean_of(record);
    const double middle = 0.5 * (static_cast<double>(record.size()) - 1.0);
    std::vector<double> x(record.begin(), record.end());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= mean + slope * (static_cast<double>(i) - middle);
    return x;
}

std::size_t independent_block(const std::vector<double>& detrended) {
    std::vector<double> square(detrended);
    for (double& v : square) v *= v;
    const double scale =
        std::max(mean_with_confidence(detrended).integral_time, mean_with_confidence(square).integral_time);
    return static_cast<std::size_t>(std::ceil(scales_per_block * scale));
}

Stationarity::OfBlocks test_of_blocks(std::span<const double> record, std::size_t count) {
    const std::size_t length = record.size() / count;
    std::vector<double> means(count);
    std::vector<double> squares(count);
    for (std::size_t b = 0; b < count; ++b) {
        const auto block = record.subspan(b * length, length);
        means[b] = mean_of(block);
        for (const double v : block) squares[b] += (v - means[b]) * (v - means[b]);
    }
    return {reverse_arrangements_p_value(means), runs_p_value(means), reverse_arrangements_p_value(squares),
            runs_p_value(squares)};
}

}  // namespace

double reverse_arrangements_p_value(std::span<const double> numbers) {
    const std::size_t n = numbers.size();
    double count = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            if (numbers[i] > numbers[j]) count += 1.0;
            if (numbers[i] == numbers[j]) count += 0.5;
        }
    }
    // The distribution is symmetric about its mean.
    const auto most = 0.5 * static_cast<double>(n) * (static_cast<double>(n) - 1.0);
    const double smaller = std::min(count, most - count);
    const std::vector<double> chance = arrangements_distribution(n);
    double tail = 0.0;
    for (std::size_t k = 0; k < chance.size() && static_cast<double>(k) <= smaller; ++k) tail += chance[k];
    return std::min(2.0 * tail, 1.0);
}

double runs_p_value(std::span<const double> numbers) {
    if (numbers.empty()) return 1.0;
    const double median = median_of(numbers);
    std::vector<bool> above;
    for (const double v : numbers) {
        if (v != median) above.push_back(v > median);
    }
    const auto a = static_cast<std::size_t>(std::count(above.begin(), above.end(), true));
    const std::size_t b = above.size() - a;
    if (a == 0 || b == 0) return 1.0;
    std::size_t runs = 1;
    for (std::size_t i = 1; i < above.size(); ++i) runs += above[i] != above[i - 1] ? 1 : 0;
    double tail = 0.0;
    for (std::size_t r = 2; r <= runs; ++r) tail += runs_chance(r, a, b);
    return std::min(tail, 1.0);
}

Stationarity stationarity(std::span<const double> record) {
    require_no_gaps(record, "test of stationarity");
    if (record.size() < smallest_record) {
        throw InputError("test of stationarity: " + std::to_string(record.size()) + " samples; at least " +
                         std::to_string(smallest_record) + " are needed");
    }
    Stationarity result;
    const TrendEstimate trend = trend_with_confidence(record);
    const auto n = static_cast<double>(record.size());
    result.drift = {trend.slope * n, trend.half_width * n};
    result.trend_p_value = two_sided_p_value(trend);
    result.block_length = independent_block(without_trend(record, trend.slope));
    result.block_count = record.size() / result.block_length;
    result.p_value = result.trend_p_value;
    if (result.block_count >= fewest_blocks) {
        const std::size_t used = std::min(result.block_count, most_blocks);
        result.block_length = record.size() / used;
        const Stationarity::OfBlocks p = test_of_blocks(record, used);
        result.blocks = p;
        result.p_value = 5.0 * std::min({result.trend_p_value, p.mean_arrangements, p.mean_runs,
                                         p.variance_arrangements, p.variance_runs});
    }
    result.p_value = std::min(result.p_value, 1.0);
    return result;
}

}  // namespace riffle::inline statistics
