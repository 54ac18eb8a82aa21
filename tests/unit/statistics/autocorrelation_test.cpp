#include "statistics/autocorrelation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "synthetic.hpp"

namespace riffle::autocorrelation_test {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// By the definition, pair by pair.
double direct(const std::vector<double>& x, std::size_t lag, LagDivisor divisor) {
    double mean = 0;
    double count = 0;
    for (const double v : x) {
        if (!std::isnan(v)) mean += v, ++count;
    }
    mean /= count;
    double sum = 0;
    double pairs = 0;
    for (std::size_t i = 0; i + lag < x.size(); ++i) {
        if (!std::isnan(x[i]) && !std::isnan(x[i + lag])) sum += (x[i] - mean) * (x[i + lag] - mean), ++pairs;
    }
    return sum / (divisor == LagDivisor::unbiased ? pairs : count);
}

TEST(Autocovariance, IsTheSumOverPairsWithAndWithoutGaps) {
    std::mt19937_64 generator(5);
    for (const bool gaps : {false, true}) {
        std::vector<double> x = synthetic::autoregressive(301, 0.8, generator);
        for (double& v : x) v += 10;
        if (gaps) synthetic::cut_gaps(x, 0.3, 7, generator);
        for (const LagDivisor divisor : {LagDivisor::biased, LagDivisor::unbiased}) {
            const std::vector<double> found = autocovariance(x, 280, divisor);
            ASSERT_EQ(found.size(), 281U);
            for (std::size_t lag = 0; lag <= 280; ++lag) {
                const double expected = direct(x, lag, divisor);
                if (std::isnan(expected)) {
                    ASSERT_TRUE(std::isnan(found[lag]));
                } else {
                    // Rounding of sums of 301 products of order 10, over few pairs at the largest lags.
                    ASSERT_NEAR(found[lag], expected, 1e-11) << "lag " << lag;
                }
            }
        }
    }
}

TEST(Autocovariance, LagsWithoutPairsAreNotANumber) {
    const std::vector<double> x{1, gap, 2, gap, 4};
    const std::vector<double> c = autocovariance(x, 4, LagDivisor::unbiased);
    EXPECT_TRUE(std::isnan(c[1]));
    EXPECT_TRUE(std::isnan(c[3]));
    EXPECT_NEAR(c[4], (1 - 7.0 / 3) * (4 - 7.0 / 3), 1e-14);
}

TEST(Autocovariance, RefusesWhatItCannotDo) {
    const std::vector<double> x{1, 2, 3};
    EXPECT_THROW((void)autocovariance(x, 3), InputError);
    EXPECT_THROW((void)autocovariance(std::vector<double>{gap, 2, gap}, 1), InputError);
    EXPECT_THROW((void)autocovariance(std::vector<double>{1, 2, INFINITY}, 1), InputError);
    EXPECT_THROW((void)autocorrelation(std::vector<double>{0.1, 0.1, 0.1}, 1), InputError);
}

TEST(Autocorrelation, OfAnAutoregressiveRecord) {
    // Variance of the estimate at lag k (Bartlett): about (1 + phi^2)/(1 - phi^2)/n for large k, less before.
    constexpr double phi = 0.8;
    constexpr std::size_t n = 100000;
    std::mt19937_64 generator(9);
    const std::vector<double> rho = autocorrelation(synthetic::autoregressive(n, phi, generator), 40);
    const double deviation = std::sqrt((1 + phi * phi) / (1 - phi * phi) / n);
    for (std::size_t k = 0; k <= 40; ++k) EXPECT_NEAR(rho[k], std::pow(phi, k), 4 * deviation);
}

TEST(IntegralScale, OfKnownCorrelations) {
    // phi^k: 1/2 + phi/(1 - phi), the window leaves out about exp(-5) of it.
    std::vector<double> exponential(2000);
    for (std::size_t k = 0; k < exponential.size(); ++k) exponential[k] = std::pow(0.99, k);
    const IntegralScale windowed = integral_scale_of_window(exponential);
    EXPECT_TRUE(windowed.closed);
    EXPECT_NEAR(windowed.scale, synthetic::integral_scale(0.99), 0.01 * windowed.scale);
    EXPECT_FALSE(integral_scale_to_zero_crossing(exponential).closed);

    // cos(k/50) to its zero at 25 pi: 50. Trapezoids of steps 1/50 err by 1/12 of their square.
    std::vector<double> cosine(200);
    for (std::size_t k = 0; k < cosine.size(); ++k) cosine[k] = std::cos(static_cast<double>(k) / 50);
    const IntegralScale crossing = integral_scale_to_zero_crossing(cosine);
    EXPECT_TRUE(crossing.closed);
    EXPECT_NEAR(crossing.scale, 50, 50.0 / 2500);

    // A triangle that ends between two lags: half its base, exactly.
    std::vector<double> triangle(20);
    for (std::size_t k = 0; k < triangle.size(); ++k) triangle[k] = 1 - static_cast<double>(k) / 7.3;
    EXPECT_NEAR(integral_scale_to_zero_crossing(triangle).scale, 3.65, 1e-12);
    EXPECT_EQ(integral_scale_to_zero_crossing(std::vector<double>{1, 0.5}).scale, 0.75);
}

TEST(IntegralScale, OfTheMeanIsThatOfTheCorrelation) {
    // One formula: in a record too short for averages of blocks, the mean's integral time is the windowed
    // scale but for its correction of the bias from the removed mean, (2 window + 1)/n (Wolff 2004, eq. 49).
    std::mt19937_64 generator(2);
    const std::vector<double> x = synthetic::autoregressive(500, 0.8, generator);
    const IntegralScale integral = integral_scale_of_window(autocorrelation(x, 249));
    const double expected = integral.scale * (1 + (2.0 * static_cast<double>(integral.window) + 1) / 500);
    EXPECT_NEAR(mean_with_confidence(x).integral_time, expected, 1e-10);
}

}  // namespace
}  // namespace riffle::autocorrelation_test
