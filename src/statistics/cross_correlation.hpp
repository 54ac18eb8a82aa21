#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "statistics/autocorrelation.hpp"

namespace riffle::inline statistics {

/// Normalised cross-correlation of two records taken at the same times (the thesis' eq. 4.7),
/// R(lag) = <a'(t) b'(t + lag)> / sqrt(<a'^2> <b'^2>): what appears in `a` appears in `b` a time `lag` later.
struct CrossCorrelation {
    std::vector<double> lag;  ///< from the most negative, in the unit of the sampling interval
    std::vector<double> correlation;
    /// |R| exceeds this at a given lag in 5 % of unrelated records of the same correlations in time.
    std::vector<double> significance;
    double effective_samples = 0;  ///< that the significance at lag zero is of
};

/// For lags of up to `largest_lag` samples of either sign. The divisor is the number of pairs (unbiased) or
/// of samples (biased: never beyond +-1, smaller by 1 - |lag|/n). Gaps (not-a-number) are left out; R is
/// not-a-number at a lag without pairs if unbiased. The significance is Bartlett's: unrelated records of n
/// pairs scatter like n / sum over all lags of rho_a rho_b independent ones, rho their autocorrelations
/// (Bartlett 1946), summed to the window of integral_scale_of_window(); it is that of one lag, while the
/// largest of many lags is larger by chance. Throws InputError where the lengths differ, a lag is not below
/// the length, the interval is not positive, a sample is infinite or a record constant.
[[nodiscard]] CrossCorrelation cross_correlation(std::span<const double> a, std::span<const double> b,
                                                 double interval, std::size_t largest_lag,
                                                 LagDivisor divisor = LagDivisor::unbiased);

/// A local maximum or minimum of a cross-correlation, placed between the lags by a parabola.
struct CorrelationExtreme {
    double lag = 0;
    double correlation = 0;
    bool maximum = true;
    bool significant = false;  ///< |correlation| above the significance at its lag
};

/// Of extremes within this share of the largest, as a wave that repeats has them, none is the largest by
/// right.
inline constexpr double as_good_correlation = 0.95;

/// All local extremes in order of the lag; the first and the last lag are none.
[[nodiscard]] std::vector<CorrelationExtreme> correlation_extremes(const CrossCorrelation& correlation);

}  // namespace riffle::inline statistics
