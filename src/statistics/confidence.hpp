#pragma once

#include <span>

namespace riffle {

/// A mean with its uncertainty, the correlation of successive samples taken into account.
struct MeanEstimate {
    double mean = 0;
    double standard_deviation = 0;  ///< of the samples
    double half_width = 0;          ///< of the 95 % confidence interval of the mean
    double integral_time = 0;       ///< integral scale of the autocorrelation, in samples
    double effective_samples = 0;
};

/// Mean of an equally spaced record with its 95 % interval: the variance of the mean is inflated by the
/// integrated autocorrelation time (Sokal's self-consistent window), Student's t on the effective samples.
[[nodiscard]] MeanEstimate mean_with_confidence(std::span<const double> samples);

/// Linear trend of an equally spaced record with a 95 % interval that takes correlation into account.
struct TrendEstimate {
    double slope = 0;       ///< per sample
    double half_width = 0;  ///< of the 95 % interval of the slope
};
[[nodiscard]] TrendEstimate trend_with_confidence(std::span<const double> samples);

}  // namespace riffle
