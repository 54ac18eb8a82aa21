#pragma once

#include <optional>
#include <span>

namespace riffle::inline statistics {

/// A mean with its uncertainty, the correlation of successive samples taken into account.
struct MeanEstimate {
    double mean = 0;
    double standard_deviation = 0;  ///< of the samples
    double half_width = 0;          ///< of the 95 % confidence interval of the mean
    double integral_time = 0;       ///< integral scale of the autocorrelation, in samples
    double effective_samples = 0;
};

/// Fewer independent samples than these make no interval that can be trusted: the autocorrelation itself is
/// not known from a record so short.
inline constexpr double fewest_effective_samples = 10.0;

/// A half-width from so many independent samples; none where they are too few to know it.
[[nodiscard]] constexpr std::optional<double> trusted_half_width(double half_width,
                                                                 double effective_samples) {
    if (effective_samples < fewest_effective_samples) return std::nullopt;
    return half_width;
}
[[nodiscard]] constexpr std::optional<double> trusted_half_width(const MeanEstimate& mean) {
    return trusted_half_width(mean.half_width, mean.effective_samples);
}

/// Half-width of a 95 % interval over the standard uncertainty of a normal distribution.
inline constexpr double normal_95 = 1.96;

/// Mean of an equally spaced record with its 95 % interval: the variance of the mean is inflated by the
/// integrated autocorrelation time (Sokal's self-consistent window), Student's t on the effective samples.
/// Gaps (not-a-number) are left out, of the mean and of the lagged products; the effective samples are then
/// at most those that are there.
[[nodiscard]] MeanEstimate mean_with_confidence(std::span<const double> samples);

/// Linear trend of an equally spaced record with a 95 % interval that takes correlation into account. A gap
/// (not-a-number) makes the slope not-a-number with an infinite interval.
struct TrendEstimate {
    double slope = 0;              ///< per sample
    double half_width = 0;         ///< of the 95 % interval of the slope
    double standard_error = 0;     ///< of the slope
    double effective_samples = 0;  ///< two less are the degrees of freedom of Student's t
};
[[nodiscard]] TrendEstimate trend_with_confidence(std::span<const double> samples);

}  // namespace riffle::inline statistics
