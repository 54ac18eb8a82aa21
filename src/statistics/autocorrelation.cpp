#include "statistics/autocorrelation.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "statistics/lagged_products.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

std::vector<double> autocovariance(std::span<const double> record, std::size_t largest_lag,
                                   LagDivisor divisor) {
    const Fluctuations x = fluctuations_of(record, "autocovariance");
    if (largest_lag >= record.size()) {
        throw InputError("autocovariance: lags up to " + std::to_string(largest_lag) + " of a record of " +
                         std::to_string(record.size()) + " samples; the largest lag must be less");
    }
    std::vector<double> result = lagged_products(x.values, largest_lag);
    const bool gaps = x.count < record.size();
    std::vector<double> pairs;
    if (gaps && divisor == LagDivisor::unbiased) {
        pairs = lagged_products(std::vector<double>(x.present.begin(), x.present.end()), largest_lag);
    }
    for (std::size_t lag = 0; lag <= largest_lag; ++lag) {
        auto count = static_cast<double>(x.count);
        if (divisor == LagDivisor::unbiased) {
            count = gaps ? std::round(pairs[lag]) : static_cast<double>(record.size() - lag);
        }
        result[lag] = count > 0 ? result[lag] / count : std::numeric_limits<double>::quiet_NaN();
    }
    return result;
}

std::vector<double> autocorrelation(std::span<const double> record, std::size_t largest_lag,
                                    LagDivisor divisor) {
    std::vector<double> result = autocovariance(record, largest_lag, divisor);
    const double variance = result.front();
    if (!(variance > 0.0)) throw InputError("autocorrelation: the record is constant, so it has none");
    for (double& v : result) v /= variance;
    return result;
}

IntegralScale integral_scale_to_zero_crossing(std::span<const double> correlation) {
    IntegralScale result;
    for (std::size_t lag = 1; lag < correlation.size(); ++lag) {
        const double before = correlation[lag - 1];
        const double here = correlation[lag];
        result.window = lag;
        if (here <= 0.0) {
            // Instead of the trapezoid between the lags, the triangle that ends at the crossing.
            result.scale += -0.5 * before + 0.5 * before * before / (before - here);
            result.closed = true;
            return result;
        }
        result.scale += here;
    }
    // The last trapezoid ends at the last lag.
    if (correlation.size() > 1) result.scale -= 0.5 * correlation.back();
    return result;
}

IntegralScale integral_scale_of_window(std::span<const double> correlation) {
    if (correlation.empty()) return {};
    return windowed_integral_scale([&](std::size_t lag) { return correlation[lag]; }, correlation.size() - 1);
}

}  // namespace riffle::inline statistics
