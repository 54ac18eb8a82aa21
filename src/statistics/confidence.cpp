#include "statistics/confidence.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "statistics/autocorrelation.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Records longer than this are averaged in blocks first, which bounds the cost and keeps the variance of
/// the mean.
constexpr std::size_t largest_record = 16384;

/// Blocking goes on while at least this many blocks remain: fewer would make the largest of the estimates
/// a measure of their noise.
constexpr std::size_t smallest_blocked_record = 256;

double lagged_product(std::span<const double> x, std::size_t lag) {
    return std::inner_product(x.begin() + static_cast<std::ptrdiff_t>(lag), x.end(), x.begin(), 0.0);
}

/// Sum of the autocovariance over all lags, both signs (n times the variance of the mean), of a record of
/// zero mean from which `fitted` parameters were removed. Window: Sokal (1997), "Monte Carlo methods in
/// statistical mechanics"; correction of the bias from the removed parameters: Wolff (2004), eq. 49.
double windowed_covariance_sum(std::span<const double> x, double fitted) {
    const auto n = static_cast<double>(x.size());
    const double variance = lagged_product(x, 0) / n;
    const IntegralScale integral =
        windowed_integral_scale([&](std::size_t lag) { return lagged_product(x, lag) / n / variance; },
                                std::max<std::size_t>(x.size() / 2, 1) - 1);
    const double bias = 1.0 + fitted * (2.0 * static_cast<double>(integral.window) + 1.0) / n;
    // Never more effective samples than samples: negative correlation is not used to narrow the interval.
    return 2.0 * std::max(integral.scale, 0.5) * variance * bias;
}

std::vector<double> block_means(std::span<const double> x, std::size_t block) {
    std::vector<double> means(x.size() / block);
    for (std::size_t i = 0; i < means.size(); ++i) means[i] = mean_of(x.subspan(i * block, block));
    return means;
}

void remove_mean(std::vector<double>& x) {
    const double mean = mean_of(x);
    for (double& v : x) v -= mean;
}

/// n times the variance of the mean of a record of zero mean. The windowed sum is repeated on the record
/// averaged in blocks of 2, 4, 8 ... samples and the largest is taken: an oscillation (waves, sound)
/// closes the window early and would hide a slower component, which the averages bring out.
double covariance_sum(std::span<const double> centred, double fitted) {
    std::size_t block = (centred.size() + largest_record - 1) / largest_record;
    double largest = 0.0;
    for (;;) {
        std::vector<double> means = block_means(centred, block);
        remove_mean(means);
        if (lagged_product(means, 0) > 0.0) {
            largest = std::max(largest, static_cast<double>(block) * windowed_covariance_sum(means, fitted));
        }
        block *= 2;
        if (centred.size() / block < smallest_blocked_record) return largest;
    }
}

/// 97.5 % point of Student's t; degrees of freedom below one are taken as one.
double student_factor(double degrees_of_freedom) {
    const boost::math::students_t distribution(std::max(degrees_of_freedom, 1.0));
    return boost::math::quantile(boost::math::complement(distribution, 0.025));
}

bool constant(std::span<const double> x) {
    return std::all_of(x.begin(), x.end(), [first = x.front()](double v) { return v == first; });
}

}  // namespace

MeanEstimate mean_with_confidence(std::span<const double> samples) {
    MeanEstimate result;
    result.mean = mean_of(samples);
    // Zeros in the gaps add nothing to the lagged products: their sum over all lags is, gaps or not, the
    // square of the number of samples times the variance of the mean.
    std::vector<double> centred(samples.begin(), samples.end());
    std::size_t count = 0;
    for (double& v : centred) {
        if (!std::isnan(v)) ++count;
        v = std::isnan(v) ? 0.0 : v - result.mean;
    }
    const auto present = static_cast<double>(count);
    result.integral_time = 0.5;
    result.effective_samples = present;
    if (count < 2) {
        result.half_width = infinity;
        return result;
    }
    const double sum_of_squares = lagged_product(centred, 0);
    if (sum_of_squares == 0.0) return result;

    const auto n = static_cast<double>(samples.size());
    result.standard_deviation = std::sqrt(sum_of_squares / (present - 1.0));
    const double sum = covariance_sum(centred, 1.0) * (n / present);
    const double variance = sum_of_squares / present;
    result.integral_time = std::max(0.5 * sum / variance, 0.5);
    result.effective_samples = std::clamp(present * variance / sum, 1.0, present);
    result.half_width = student_factor(result.effective_samples - 1.0) * std::sqrt(sum / present);
    return result;
}

TrendEstimate trend_with_confidence(std::span<const double> samples) {
    TrendEstimate result;
    if (samples.size() < 3) {
        if (samples.size() == 2) result.slope = samples[1] - samples[0];
        result.half_width = infinity;
        return result;
    }
    if (constant(samples)) {
        result.effective_samples = static_cast<double>(samples.size());
        return result;
    }

    const auto n = static_cast<double>(samples.size());
    const double mean = mean_of(samples);
    const double middle = 0.5 * (n - 1.0);
    const double spread = n * (n * n - 1.0) / 12.0;  // sum of (i - middle)^2
    double moment = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        moment += (static_cast<double>(i) - middle) * (samples[i] - mean);
    }
    result.slope = moment / spread;

    std::vector<double> residual(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        residual[i] = samples[i] - mean - result.slope * (static_cast<double>(i) - middle);
    }
    if (std::isnan(result.slope)) {
        result.half_width = infinity;
        return result;
    }
    const double sum = covariance_sum(residual, 2.0);
    if (sum == 0.0) {
        result.effective_samples = n;
        return result;
    }
    const double variance = lagged_product(residual, 0) / n;
    result.effective_samples = std::min(n * variance / sum, n);
    result.standard_error = std::sqrt(sum / spread);
    result.half_width = student_factor(result.effective_samples - 2.0) * result.standard_error;
    return result;
}

}  // namespace riffle::inline statistics
