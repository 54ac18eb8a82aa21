#include "statistics/probability_density.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline statistics {

namespace {

constexpr std::size_t smallest_record = 8;
constexpr double largest_automatic_bins = 200;
constexpr double largest_bins = 2000;

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
    for (std::size_t lag = 1; lag <= window; ++lag) {
        sum += 2.0 * shape_covariance(rho[lag]) / shape_covariance(1.0);
    }
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
    if (m.variance.value == 0.0) {
        throw InputError("probability density: the record is constant, so it has none");
    }
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
                         std::to_string(range) + "; the width must be positive and make less than 2000 bins");
    }
    return width;
}

/// Bins of a width about the mean, from the one with the smallest sample to the one with the largest.
struct Bins {
    double mean, width;
    long first, count;

    [[nodiscard]] long of(double sample) const {
        return std::lround(std::floor((sample - mean) / width + 0.5)) - first;
    }
    [[nodiscard]] double centre(long bin) const { return mean + static_cast<double>(first + bin) * width; }
};

Bins bins_of(const std::vector<double>& sorted, double mean, double width) {
    Bins bins{mean, width, 0, 0};
    bins.first = bins.of(sorted.front());
    bins.count = bins.of(sorted.back()) + 1;
    return bins;
}

/// For each bin the share of the samples in it, as a record: one value for each block of consecutive samples,
/// so that a long record costs no more for each bin than mean_with_confidence() needs; not-a-number for a
/// block of gaps.
std::vector<std::vector<double>> shares_of_blocks(std::span<const double> record, const Bins& bins) {
    constexpr std::size_t most_blocks = 16384;
    const std::size_t block = (record.size() + most_blocks - 1) / most_blocks;
    const std::size_t blocks = (record.size() + block - 1) / block;
    std::vector<std::vector<double>> shares(static_cast<std::size_t>(bins.count),
                                            std::vector<double>(blocks));
    std::vector<double> present(blocks);
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (std::isnan(record[i])) continue;
        shares[static_cast<std::size_t>(bins.of(record[i]))][i / block] += 1.0;
        present[i / block] += 1.0;
    }
    for (std::vector<double>& share : shares) {
        for (std::size_t b = 0; b < blocks; ++b) share[b] /= present[b];
    }
    return shares;
}

/// Half-width of the share of `count` samples in a bin.
double half_width_of_share(const std::vector<double>& share_of_blocks, double share, double count,
                           double fallback_samples) {
    const MeanEstimate mean = mean_with_confidence(share_of_blocks);
    const double variance = mean.standard_deviation * mean.standard_deviation / mean.effective_samples;
    const double samples =
        variance > 0.0 ? std::clamp(share * (1.0 - share) / variance, 1.0, count) : fallback_samples;
    const double centre = (share * samples + 2.0) / (samples + 4.0);
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
    const Bins bins = bins_of(sorted, mean, width);
    const std::vector<std::vector<double>> shares = shares_of_blocks(record, bins);
    std::vector<double> samples(shares.size());
    for (const double v : sorted) samples[static_cast<std::size_t>(bins.of(v))] += 1.0;
    const auto count = static_cast<double>(sorted.size());
    for (std::size_t bin = 0; bin < shares.size(); ++bin) {
        const double centre = bins.centre(static_cast<long>(bin));
        const double share = samples[bin] / count;
        result.centre.push_back(centre);
        result.density.push_back(share / width);
        const double half = half_width_of_share(shares[bin], share, count, result.moments.effective_samples);
        result.half_width.push_back(half / width);
        result.gaussian.push_back((gaussian_distribution((centre + 0.5 * width - mean) / deviation) -
                                   gaussian_distribution((centre - 0.5 * width - mean) / deviation)) /
                                  width);
    }
    result.test = test_of(record, sorted, result.moments);
    return result;
}

}  // namespace riffle::inline statistics
