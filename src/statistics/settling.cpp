#include "statistics/settling.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle {

SettlingCurve settling_curve(std::span<const double> record, std::size_t points) {
    if (record.empty() || points == 0) {
        throw InputError("settling curve: at least one sample and one point are needed");
    }
    const std::size_t n = record.size();
    const std::size_t count = std::min(points, n);
    SettlingCurve curve;
    for (std::size_t p = 1; p <= count; ++p) {
        const std::size_t samples = p * n / count;
        const MeanEstimate mean = mean_with_confidence(record.first(samples));
        curve.samples.push_back(samples);
        curve.mean.push_back(mean.mean);
        curve.half_width.push_back(mean.half_width);
    }
    return curve;
}

std::size_t settled_after(std::span<const double> record, double band) {
    if (!(band > 0.0)) throw InputError("settling: the band about the mean must be positive");
    const double mean = mean_of(record);
    if (std::isnan(mean)) throw InputError("settling: the record holds no samples");
    double sum = 0.0;  // of the departures, so that a mean far from zero costs no digits
    double count = 0.0;
    std::size_t settled = 0;
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (!std::isnan(record[i])) {
            sum += record[i] - mean;
            count += 1.0;
        }
        if (count == 0.0 || std::abs(sum / count) > band) settled = i + 1;
    }
    // After the last sample outside the band comes the first that is within.
    return std::min(settled + 1, record.size());
}

std::optional<std::size_t> transient_length(std::span<const double> record) {
    constexpr std::size_t batch = 5;
    constexpr std::size_t smallest_record = 10 * batch;
    require_no_gaps(record, "start-up");
    if (record.size() < smallest_record) {
        throw InputError("start-up: " + std::to_string(record.size()) + " samples; at least " +
                         std::to_string(smallest_record) + " are needed");
    }
    const std::size_t blocks = record.size() / batch;
    const std::size_t rest = record.size() - blocks * batch;  // left out at the start
    const double shift = mean_of(record);
    double sum = 0.0;
    double square = 0.0;
    double smallest = 0.0;
    std::size_t best = blocks;
    for (std::size_t d = blocks; d-- > 0;) {
        const double mean = mean_of(record.subspan(rest + d * batch, batch)) - shift;
        sum += mean;
        square += mean * mean;
        const auto count = static_cast<double>(blocks - d);
        if (blocks - d < batch) continue;
        const double error = (square - sum * sum / count) / (count * count);
        if (best == blocks || error <= smallest) {
            smallest = error;
            best = d;
        }
    }
    if (2 * best > blocks) return std::nullopt;
    return best == 0 ? 0 : rest + best * batch;
}

}  // namespace riffle
