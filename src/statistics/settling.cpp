#include "statistics/settling.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

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

}  // namespace riffle::inline statistics
