#include "statistics/dominant_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "statistics/fourier.hpp"

namespace riffle::inline statistics {

std::optional<Oscillation> dominant_oscillation(std::span<const double> record, double interval,
                                                double highest) {
    constexpr std::size_t padding = 8;
    const std::size_t n = record.size();
    if (n < 16 || interval <= 0.0) return std::nullopt;
    const double mean = std::accumulate(record.begin(), record.end(), 0.0) / static_cast<double>(n);
    const std::size_t length = fast_length(padding * n);
    std::vector<double> padded(length, 0.0);
    double window_sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double window =
            std::pow(std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n)), 2);
        padded[i] = window * (record[i] - mean);
        window_sum += window;
    }
    const std::vector<Complex> transform = fourier_transform(padded);
    const double step = 1.0 / (static_cast<double>(length) * interval);
    const auto power = [&](std::size_t k) { return std::norm(transform[k]); };
    // The main lobe of the window is four resolutions wide; a peak within two of zero is a trend.
    const auto lobe =
        static_cast<std::size_t>(std::ceil(2.0 * static_cast<double>(length) / static_cast<double>(n)));
    const auto last = std::min(transform.size() - 1, static_cast<std::size_t>(highest / step));
    if (last < lobe + 2) return std::nullopt;
    std::size_t peak = lobe;
    double total = 0.0;
    for (std::size_t k = 1; k < last; ++k) {
        total += power(k);
        if (k >= lobe && power(k) > power(peak)) peak = k;
    }
    if (peak <= lobe || peak + 1 >= last || total <= 0.0 || power(peak) <= power(peak - 1)) {
        return std::nullopt;
    }
    double within = 0.0;
    for (std::size_t k = peak - lobe; k <= std::min(peak + lobe, last - 1); ++k) within += power(k);
    const double before = std::log(power(peak - 1));
    const double at = std::log(power(peak));
    const double after = std::log(power(peak + 1));
    const double shift = 0.5 * (before - after) / (before - 2.0 * at + after);
    Oscillation found;
    found.frequency = (static_cast<double>(peak) + shift) * step;
    found.amplitude = 2.0 * std::sqrt(power(peak)) / window_sum;
    found.share = within / total;
    double all = 0.0;
    for (std::size_t k = 1; k < transform.size(); ++k) all += power(k);
    found.whole_share = within / all;
    found.periods = found.frequency * static_cast<double>(n) * interval;
    return found;
}

}  // namespace riffle::inline statistics
