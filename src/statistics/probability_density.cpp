#include "statistics/probability_density.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/confidence.hpp"

namespace riffle {

namespace {

constexpr std::size_t smallest_record = 8;
constexpr double largest_automatic_bins = 200;
constexpr double largest_bins = 100000;

double gaussian_distribution(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// The samples that are there, in order of size.
std::vector<double> sorted_samples(std::span<const double> record) {
    std::vector<double> x;
    std::copy_if(record.begin(), record.end(), std::back_inserter(x),
                 [](double v) { return !std::isnan(v); });
    std::sort(x.begin(), x.end());
    return x;
}

/// Dallal & Wilkinson (1986), eq. 1, for 5 to 100 samples; more are brought to 100 by their scaling.
double lilliefors_p_value(double distance, double samples) {
    double n = std::max(samples, 5.0);
    double d = distance;
    if (n > 100.0) {
        d *= std::pow(n / 100.0, 0.49);
        n = 100.0;
    }
    const double p = std::exp(-7.01256 * d * d * (n + 2.78019) + 2.99587 * d * std::sqrt(n + 2.78019) -
                              0.122119 + 0.974598 / std::sqrt(n) + 1.67997 / n);
    return std::min(p, 0.1);
}

/// What the terms of third and higher order in rho are of the covariance of two empirical distributions.
double shape_covariance(double rho) {
    const double s = std::clamp(0.5 * (1.0 + rho), -1.0, 1.0);
    const double first = 0.5 / std::sqrt(3.0 / 4.0);               // d/d rho of asin at rho = 0
    const double second = 0.5 * 0.125 / std::pow(3.0 / 4.0, 1.5);  // half of d^2/d rho^2
    return (std::asin(s) - std::numbers::pi / 6.0 - first * rho - second * rho * rho) /
           (2.0 * std::numbers::pi);
}

/// Independent samples whose empirical distribution scatters like the record's about the fitted Gaussian one.
double effective_samples_of_shape(std::span<const double> record, double samples) {
    const std::vector<double> rho = autocorrelation(record, (record.size() - 1) / 2);
    const std::size_t window = integral_scale_of_window(rho).window;
    double sum = 1.0;
    for (std::size_t lag = 1; lag <= window; ++lag)
        sum += 2.0 * shape_covariance(rho[lag]) / shape_covariance(1.0);
    return samples / std::max(sum, 1.0);
}

GaussianTest test_of(std::span<const double> record, const std::vector<double>& sorted, const Moments& m) {
    // The deviation of the samples themselves, not that of the corrected variance.
    const auto n = static_cast<double>(sorted.size());
    double square = 0.0;
    for (const double v : sorted) square += (v - m.mean.value) * (v - m.mean.value);
    const double deviation = std::sqrt(square / (n - 1.0));
    GaussianTest test;
    test.effective_samples = effective_samples_of_shape(record, n);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const double expected = gaussian_distribution((sorted[i] - m.mean.value) / deviation);
        const double below = static_cast<double>(i) / n;
        const double above = static_cast<double>(i + 1) / n;
        test.distance = std::max({test.distance, expected - below, above - expected});
    }
    test.p_value = lilliefors_p_value(test.distance, test.effective_samples);
    return test;
}

Moments moments_of(std::span<const double> record) {
    Moments m = moments(record);
    if (m.samples < smallest_record) {
        throw InputError("probability density: " + std::to_string(m.samples) +
                         " samples are there; at least " + std::to_string(smallest_record) + " are needed");
    }
    if (m.variance.value == 0.0)
        throw InputError("probability density: the record is constant, so it has none");
    return m;
}

double chosen_width(double asked, const Moments& m, double range) {
    const double deviation = m.standard_deviation.value;
    double width = asked;
    if (asked == 0.0) {
        width = std::min(3.49 / std::cbrt(m.effective_of_variance), 0.5) * deviation;
        width = std::max(width, range / largest_automatic_bins);
    }
    if (!(width > 0.0) || !(range / width < largest_bins)) {
        throw InputError("probability density: bins of " + std::to_string(asked) + " over a range of " +
                         std::to_string(range) +
                         "; the width must be positive and make less than 100000 bins");
    }
    return width;
}

/// Half-width of the share of the samples in a bin.
double half_width_of_share(std::span<const double> record, double from, double to, double fallback_samples) {
    std::vector<double> inside(record.begin(), record.end());
    for (double& v : inside) {
        if (!std::isnan(v)) v = v >= from && v < to ? 1.0 : 0.0;
    }
    const MeanEstimate share = mean_with_confidence(inside);
    const bool known = share.standard_deviation > 0.0;
    const double samples = known ? share.effective_samples : fallback_samples;
    const double centre = (share.mean * samples + 2.0) / (samples + 4.0);
    return 1.96 * std::sqrt(centre * (1.0 - centre) / (samples + 4.0));
}

}  // namespace

GaussianTest test_of_gaussian(std::span<const double> record) {
    const Moments m = moments_of(record);
    return test_of(record, sorted_samples(record), m);
}

ProbabilityDensity probability_density(std::span<const double> record, double bin_width) {
    ProbabilityDensity result;
    result.moments = moments_of(record);
    const std::vector<double> sorted = sorted_samples(record);
    const double mean = result.moments.mean.value;
    const double deviation = result.moments.standard_deviation.value;
    const double width = chosen_width(bin_width, result.moments, sorted.back() - sorted.front());
    result.bin_width = width;
    const long first = std::lround(std::floor((sorted.front() - mean) / width + 0.5));
    const long last = std::lround(std::floor((sorted.back() - mean) / width + 0.5));
    const auto count = static_cast<double>(sorted.size());
    auto sample = sorted.begin();
    for (long bin = first; bin <= last; ++bin) {
        const double from = mean + (static_cast<double>(bin) - 0.5) * width;
        const double to = mean + (static_cast<double>(bin) + 0.5) * width;
        const auto end = bin == last ? sorted.end() : std::lower_bound(sample, sorted.end(), to);
        result.centre.push_back(mean + static_cast<double>(bin) * width);
        result.density.push_back(static_cast<double>(end - sample) / (count * width));
        sample = end;
        const double half = half_width_of_share(record, from, to, result.moments.effective_samples);
        result.half_width.push_back(half / width);
        result.gaussian.push_back((gaussian_distribution((to - mean) / deviation) -
                                   gaussian_distribution((from - mean) / deviation)) /
                                  width);
    }
    result.test = test_of(record, sorted, result.moments);
    return result;
}

}  // namespace riffle
