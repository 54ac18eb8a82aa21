#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace riffle::inline statistics {

/// Divisor of a sum of products over the pairs of samples at a lag. `unbiased`: the number of pairs; the
/// estimate scatters ever more as the lag grows. `biased`: the number of samples; smaller by the factor
/// (1 - lag/n), with less scatter, and the transform of a power spectrum that is nowhere negative.
enum class LagDivisor { unbiased, biased };

/// Autocovariance at the lags 0 ... largest_lag: means of x'(t) x'(t + lag), x' the departure from the mean
/// of the whole record. Through zero-padded Fourier transforms, n log n. Gaps (not-a-number): only pairs of
/// samples that are both there count; not-a-number at a lag without pairs if unbiased. Removing the mean
/// lowers the estimate at all lags by about the variance of the mean. Throws InputError for an infinite
/// sample, fewer than two samples, or a lag not below the length.
[[nodiscard]] std::vector<double> autocovariance(std::span<const double> record, std::size_t largest_lag,
                                                 LagDivisor divisor = LagDivisor::biased);

/// The same over its value at lag zero. Throws InputError also for a constant record.
[[nodiscard]] std::vector<double> autocorrelation(std::span<const double> record, std::size_t largest_lag,
                                                  LagDivisor divisor = LagDivisor::biased);

/// Integral of an autocorrelation over the lags >= 0 by the trapezoidal rule, 1/2 + rho_1 + rho_2 + ..., up
/// to where a rule ends it. In samples; the length or time of it is this number of sampling intervals.
struct IntegralScale {
    double scale = 0.5;
    std::size_t window = 0;  ///< last lag of the sum
    bool closed = false;     ///< whether the rule ended the sum before the lags did
};

/// To the first zero crossing, interpolated linearly: what flow measurements use (Tennekes & Lumley 1972;
/// O'Neill et al. 2004). Larger than the whole integral where negative lobes follow. `correlation` starts at
/// lag zero, where it is one.
[[nodiscard]] IntegralScale integral_scale_to_zero_crossing(std::span<const double> correlation);

/// To the first lag of at least five integral scales (Sokal 1997, "Monte Carlo methods in statistical
/// mechanics"): what the uncertainty of a mean follows from. The tail left out of an exponential correlation
/// is exp(-5).
[[nodiscard]] IntegralScale integral_scale_of_window(std::span<const double> correlation);

/// Factor of Sokal's window.
constexpr double integral_window_factor = 5.0;

/// integral_scale_of_window() of a correlation that is computed lag by lag: correlation_at(lag) for lag <=
/// largest_lag.
template <class CorrelationAt>
[[nodiscard]] IntegralScale windowed_integral_scale(const CorrelationAt& correlation_at,
                                                    std::size_t largest_lag) {
    IntegralScale result;
    const auto within = [&] {
        return static_cast<double>(result.window) < integral_window_factor * result.scale;
    };
    while (result.window < largest_lag && within()) {
        ++result.window;
        result.scale += correlation_at(result.window);
    }
    result.closed = !within();
    return result;
}

}  // namespace riffle::inline statistics
