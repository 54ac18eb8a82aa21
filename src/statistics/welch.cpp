#include "statistics/welch.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

namespace {

constexpr std::size_t smallest_segment = 4;

std::size_t chosen_length(std::size_t record_length, const WelchOptions& options) {
    std::size_t length = options.segment_length;
    if (length == 0) {
        // An even length of small factors, not above an eighth.
        length = record_length / 8;
        while (length > smallest_segment && (length % 2 != 0 || fast_length(length) != length)) --length;
        length = std::min(std::max(length, smallest_segment), record_length);
    }
    if (length < smallest_segment || length > record_length) {
        throw InputError("spectrum: segments of " + std::to_string(length) + " samples of a record of " +
                         std::to_string(record_length) + "; a segment must have at least " +
                         std::to_string(smallest_segment) + " samples and not more than the record");
    }
    if (!(options.overlap >= 0.0 && options.overlap < 1.0)) {
        throw InputError("spectrum: an overlap of " + std::to_string(options.overlap) +
                         "; it must be a share of a segment from 0 to less than 1");
    }
    return length;
}

/// Periodic, of unit mean square.
std::vector<double> make_taper(std::size_t length, Taper kind) {
    std::vector<double> taper(length, 1.0);
    if (kind == Taper::none) return taper;
    const double scale = std::sqrt(8.0 / 3.0);  // the mean square of sin^2 is 3/8
    for (std::size_t i = 0; i < length; ++i) {
        const double s = std::sin(std::numbers::pi * static_cast<double>(i) / static_cast<double>(length));
        taper[i] = scale * s * s;
    }
    return taper;
}

void remove_trend(std::span<double> x, Detrend detrend) {
    const double mean = mean_of(x);
    const auto n = static_cast<double>(x.size());
    const double middle = 0.5 * (n - 1.0);
    double slope = 0.0;
    if (detrend == Detrend::line) {
        for (std::size_t i = 0; i < x.size(); ++i) slope += (static_cast<double>(i) - middle) * (x[i] - mean);
        slope /= n * (n * n - 1.0) / 12.0;
    }
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= mean + slope * (static_cast<double>(i) - middle);
}

/// |sum_i w(i) w(i + shift) exp(-2 pi i j m/n)|^2 over its value at shift 0 and m = 0: the covariance of the
/// densities of Gaussian white noise in two segments `shift` apart, m frequencies apart.
std::vector<double> shared_power(const FourierTransform& transform, std::span<const double> taper,
                                 std::size_t shift) {
    std::vector<double> product(taper.size());
    for (std::size_t i = 0; i + shift < taper.size(); ++i) product[i] = taper[i] * taper[i + shift];
    const std::vector<Complex> g = transform.forward_real(product);
    std::vector<double> power(g.size());
    const auto n = static_cast<double>(taper.size());  // the sum of the squared taper
    std::transform(g.begin(), g.end(), power.begin(),
                   [n](const Complex& v) { return std::norm(v) / (n * n); });
    return power;
}

}  // namespace

WelchSegments::WelchSegments(std::size_t record_length, const WelchOptions& options)
    : options_(options),
      transform_(chosen_length(record_length, options)),
      taper_(make_taper(transform_.length(), options.taper)) {
    const auto kept = static_cast<double>(length()) * (1.0 - options.overlap);
    step_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(kept)));
    count_ = (record_length - length()) / step_ + 1;
    shared_ = shared_power(transform_, taper_, 0);
    for (std::size_t j = 1; j < count_ && j * step_ < length(); ++j) {
        const std::vector<double> power = shared_power(transform_, taper_, j * step_);
        const double weight = 2.0 * (1.0 - static_cast<double>(j) / static_cast<double>(count_));
        for (std::size_t m = 0; m < shared_.size(); ++m) shared_[m] += weight * power[m];
    }
}

std::vector<Complex> WelchSegments::spectrum(std::span<const double> record, std::size_t segment) const {
    const auto part = record.subspan(segment * step_, length());
    std::vector<double> x(part.begin(), part.end());
    remove_trend(x, options_.detrend);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] *= taper_[i];
    std::vector<Complex> result = transform_.forward_real(x);
    // Both signs of a frequency in one, but for zero and, of an even length, half the sampling rate.
    const double one = 1.0 / std::sqrt(static_cast<double>(length()));
    const std::size_t single = length() % 2 == 0 ? length() / 2 : length();
    for (std::size_t k = 0; k < result.size(); ++k) {
        result[k] *= k == 0 || k == single ? one : std::numbers::sqrt2 * one;
    }
    return result;
}

double WelchSegments::shared_within(std::size_t bins) const {
    double sum = static_cast<double>(bins) * shared_.front();
    for (std::size_t d = 1; d < std::min(bins, shared_.size()); ++d) {
        sum += 2.0 * static_cast<double>(bins - d) * shared_[d];
    }
    return sum;
}

double WelchSegments::degrees_of_freedom(std::size_t bins) const {
    const auto m = static_cast<double>(bins);
    return 2.0 * static_cast<double>(count_) * m * m / shared_within(bins);
}

double WelchSegments::correlation_of_neighbours(std::size_t first, std::size_t second) const {
    double sum = 0.0;
    for (std::size_t d = 1; d < std::min(first + second, shared_.size()); ++d) {
        const std::size_t pairs = std::min({d, first, second, first + second - d});
        sum += static_cast<double>(pairs) * shared_[d];
    }
    return sum / std::sqrt(shared_within(first) * shared_within(second));
}

}  // namespace riffle::inline statistics
