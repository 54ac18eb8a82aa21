#include "statistics/cross_correlation.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "statistics/lagged_products.hpp"
#include "statistics/peak.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

namespace {

double sum_of_squares(const std::vector<double>& x) {
    return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

/// Number of pairs at the lags -largest_lag ... largest_lag.
std::vector<double> pairs_of(const Fluctuations& a, const Fluctuations& b, std::size_t largest_lag) {
    const std::size_t n = a.values.size();
    std::vector<double> pairs(2 * largest_lag + 1);
    if (a.count == n && b.count == n) {
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const std::size_t lag = i < largest_lag ? largest_lag - i : i - largest_lag;
            pairs[i] = static_cast<double>(n - lag);
        }
        return pairs;
    }
    pairs = lagged_products(std::vector<double>(a.present.begin(), a.present.end()),
                            std::vector<double>(b.present.begin(), b.present.end()), largest_lag);
    for (double& p : pairs) p = std::round(p);
    return pairs;
}

/// |R| of 5 % of records with `samples` independent pairs.
double significance_of(double samples) {
    const double degrees = std::max(samples - 2.0, 1.0);
    const double t = quantile(complement(boost::math::students_t(degrees), 0.025));
    return t / std::sqrt(t * t + degrees);
}

}  // namespace

CrossCorrelation cross_correlation(std::span<const double> a, std::span<const double> b, double interval,
                                   std::size_t largest_lag, LagDivisor divisor) {
    require_same_length(a, b, "cross-correlation");
    if (largest_lag >= a.size()) {
        throw InputError("cross-correlation: lags up to " + std::to_string(largest_lag) + " of records of " +
                         std::to_string(a.size()) + " samples; the largest lag must be less");
    }
    if (!(interval > 0.0)) throw InputError("cross-correlation: the sampling interval must be positive");
    const Fluctuations x = fluctuations_of(a, "cross-correlation");
    const Fluctuations y = fluctuations_of(b, "cross-correlation");
    const double xx = sum_of_squares(x.values);
    const double yy = sum_of_squares(y.values);
    if (xx == 0.0 || yy == 0.0) throw InputError("cross-correlation: a record is constant, so it has none");

    const std::size_t half = (a.size() - 1) / 2;
    const std::vector<double> of_x = autocorrelation(a, half);
    const std::vector<double> of_y = autocorrelation(b, half);
    const IntegralScale shared =
        windowed_integral_scale([&](std::size_t lag) { return of_x[lag] * of_y[lag]; }, half);
    const double per_independent = 2.0 * std::max(shared.scale, 0.5);

    const std::vector<double> pairs = pairs_of(x, y, largest_lag);
    const auto count_x = static_cast<double>(x.count);
    const auto count_y = static_cast<double>(y.count);
    CrossCorrelation result;
    result.effective_samples = pairs[largest_lag] / per_independent;
    result.correlation = lagged_products(x.values, y.values, largest_lag);
    result.lag.resize(result.correlation.size());
    result.significance.resize(result.correlation.size());
    for (std::size_t i = 0; i < result.correlation.size(); ++i) {
        result.lag[i] = interval * (static_cast<double>(i) - static_cast<double>(largest_lag));
        // Share of the pairs in the divisor: one if unbiased.
        const double share = pairs[i] / std::sqrt(count_x * count_y);
        if (!(pairs[i] > 0.0)) {
            result.correlation[i] =
                divisor == LagDivisor::biased ? 0.0 : std::numeric_limits<double>::quiet_NaN();
            result.significance[i] = 1.0;
            continue;
        }
        result.correlation[i] /= std::sqrt(xx * yy);
        result.significance[i] = significance_of(pairs[i] / per_independent);
        if (divisor == LagDivisor::unbiased) {
            result.correlation[i] /= share;
        } else {
            result.significance[i] *= share;
        }
    }
    return result;
}

std::vector<CorrelationExtreme> correlation_extremes(const CrossCorrelation& correlation) {
    const std::vector<double>& r = correlation.correlation;
    std::vector<CorrelationExtreme> extremes;
    for (std::size_t i = 1; i + 1 < r.size(); ++i) {
        const bool maximum = r[i] > r[i - 1] && r[i] >= r[i + 1];
        const bool minimum = r[i] < r[i - 1] && r[i] <= r[i + 1];
        if (!maximum && !minimum) continue;
        const ParabolaExtreme refined = parabola_extreme(r[i - 1], r[i], r[i + 1]);
        const double step = correlation.lag[i + 1] - correlation.lag[i];
        extremes.push_back({correlation.lag[i] + step * refined.offset, refined.value, maximum,
                            std::abs(refined.value) > correlation.significance[i]});
    }
    return extremes;
}

}  // namespace riffle::inline statistics
