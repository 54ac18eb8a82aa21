#include "statistics/moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/not_a_number.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

namespace {

constexpr Estimate undefined{not_a_number, std::numeric_limits<double>::infinity()};

/// influence(i) for each sample that is there; its mean with confidence.
template <class Influence>
MeanEstimate mean_of_influence(const std::vector<bool>& present, const Influence& influence) {
    std::vector<double> record(present.size(), not_a_number);
    for (std::size_t i = 0; i < present.size(); ++i) {
        if (present[i]) record[i] = influence(i);
    }
    return mean_with_confidence(record);
}

/// A second moment of fluctuations about the samples' own mean is too small by 1/effective samples of the
/// mean.
double bias_correction(double effective_samples) {
    return 1.0 / (1.0 - 1.0 / std::max(effective_samples, 2.0));
}

}  // namespace

Moments moments(std::span<const double> record) {
    const Fluctuations x = fluctuations_of(record, "moments");
    Moments result;
    result.samples = x.count;
    const MeanEstimate mean = mean_with_confidence(record);
    result.mean = {mean.mean, mean.half_width};
    result.integral_scale = mean.integral_time;
    result.effective_samples = mean.effective_samples;

    const MeanEstimate square =
        mean_of_influence(x.present, [&](std::size_t i) { return x.values[i] * x.values[i]; });
    result.effective_of_variance = square.effective_samples;
    if (square.mean == 0.0) {
        result.skewness = result.excess_kurtosis = undefined;
        return result;
    }
    const double correction = bias_correction(mean.effective_samples);
    result.variance = {correction * square.mean, correction * square.half_width};
    result.standard_deviation.value = std::sqrt(result.variance.value);
    result.standard_deviation.half_width = 0.5 * result.variance.half_width / result.standard_deviation.value;

    const double scale = 1.0 / std::sqrt(square.mean);
    double third = 0.0;
    double fourth = 0.0;
    for (const double v : x.values) {
        const double z = scale * v;
        third += z * z * z;
        fourth += z * z * z * z;
    }
    third /= static_cast<double>(x.count);
    fourth /= static_cast<double>(x.count);
    const MeanEstimate skewness = mean_of_influence(x.present, [&](std::size_t i) {
        const double z = scale * x.values[i];
        return z * z * z - 3.0 * z - third - 1.5 * third * (z * z - 1.0);
    });
    const MeanEstimate kurtosis = mean_of_influence(x.present, [&](std::size_t i) {
        const double z = scale * x.values[i];
        return z * z * z * z - 4.0 * third * z - fourth - 2.0 * fourth * (z * z - 1.0);
    });
    result.skewness = {third, skewness.half_width};
    result.excess_kurtosis = {fourth - 3.0, kurtosis.half_width};
    return result;
}

Covariance covariance(std::span<const double> a, std::span<const double> b) {
    const PairOfFluctuations pair = fluctuations_of(a, b, "covariance");
    const Fluctuations& x = pair.first;
    const Fluctuations& y = pair.second;
    Covariance result;
    result.samples = x.count;
    double xx = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.values.size(); ++i) {
        xx += x.values[i] * x.values[i];
        yy += y.values[i] * y.values[i];
    }
    const auto n = static_cast<double>(x.count);
    const MeanEstimate product =
        mean_of_influence(x.present, [&](std::size_t i) { return x.values[i] * y.values[i]; });
    result.effective_samples = product.effective_samples;
    // The means of both records enter the product: the correlation of the fluctuations is that of the slower
    // at most.
    const double of_mean =
        std::max(mean_of_influence(x.present, [&](std::size_t i) { return x.values[i]; }).effective_samples,
                 mean_of_influence(x.present, [&](std::size_t i) { return y.values[i]; }).effective_samples);
    const double correction = bias_correction(of_mean);
    result.covariance = {correction * product.mean, correction * product.half_width};
    if (xx == 0.0 || yy == 0.0) {
        result.correlation = undefined;
        return result;
    }
    const double over_x = std::sqrt(n / xx);
    const double over_y = std::sqrt(n / yy);
    const double r = product.mean * over_x * over_y;
    const MeanEstimate influence = mean_of_influence(x.present, [&](std::size_t i) {
        const double u = over_x * x.values[i];
        const double v = over_y * y.values[i];
        return u * v - 0.5 * r * (u * u + v * v);
    });
    result.correlation = {r, influence.half_width};
    return result;
}

}  // namespace riffle::inline statistics
