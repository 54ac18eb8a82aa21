#include "statistics/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "synthetic.hpp"

namespace riffle::moments_test {
namespace {

using synthetic::autoregressive;

constexpr int trials = 400;
const double band = 3 * synthetic::share_deviation(0.95, trials);

/// Counts intervals that hold the truth.
struct Count {
    const char* name;
    int held = 0;
    double sum = 0;

    void add(const Estimate& e, double truth) {
        held += std::abs(e.value - truth) <= e.half_width ? 1 : 0;
        sum += e.value;
    }
    /// `asymptotic`: what the next order of 1/n, left out by the intervals, adds to the binomial band.
    void expect_coverage(const std::string& of, double asymptotic) const {
        const double share = static_cast<double>(held) / trials;
        std::printf("%s: %s covered %.1f %%, mean of the estimates %.4f\n", of.c_str(), name, 100 * share,
                    sum / trials);
        EXPECT_GE(share, 0.95 - band - asymptotic) << name;
        EXPECT_LE(share, 0.95 + band) << name;
    }
};

struct Record {
    double phi;
    std::size_t n;
    double missing;
};

// x^2 of an AR(1) record of phi is one of phi^2: 1/2 (1 + phi^2)/(1 - phi^2) is its integral scale.
TEST(Moments, IntervalsCoverTheTruthOfAutoregressiveRecords) {
    for (const auto& [phi, n, missing] :
         {Record{0.0, 500, 0}, Record{0.9, 4000, 0}, Record{0.9, 6000, 0.3}}) {
        Count mean{"mean"};
        Count variance{"variance"};
        Count deviation{"standard deviation"};
        Count skewness{"skewness"};
        Count kurtosis{"excess kurtosis"};
        double effective = 0;
        for (int i = 0; i < trials; ++i) {
            std::mt19937_64 generator(static_cast<std::uint64_t>(i));
            std::vector<double> x = autoregressive(n, phi, generator);
            for (double& v : x) v = 5 + 2 * v;
            synthetic::cut_gaps(x, missing, 20, generator);
            const Moments m = moments(x);
            mean.add(m.mean, 5);
            variance.add(m.variance, 4);
            deviation.add(m.standard_deviation, 2);
            skewness.add(m.skewness, 0);
            kurtosis.add(m.excess_kurtosis, 0);
            effective += m.effective_of_variance / trials;
        }
        const std::string of = "phi " + std::to_string(phi) + ", n " + std::to_string(n);
        mean.expect_coverage(of, 0);
        // Errors of the second moments are skewed, more so the fewer samples: order 1/sqrt(n) of one side of
        // the interval, 1/n of both, with n of a few hundred.
        variance.expect_coverage(of, 0.01);
        deviation.expect_coverage(of, 0.01);
        skewness.expect_coverage(of, 0.01);
        // The kurtosis' error has the skewness of fourth powers.
        kurtosis.expect_coverage(of, 0.04);
        if (missing == 0) {
            const double expected = static_cast<double>(n) / (2 * synthetic::integral_scale(phi * phi));
            EXPECT_LT(effective, 1.1 * expected);
            EXPECT_GT(effective, 0.7 * expected);  // the largest of blocked estimates: above by design
        }
    }
}

TEST(Moments, VarianceOfShortCorrelatedRecordsIsNotBiased) {
    // 100 integral scales: the plain variance is 2 % too small. The mean of 4000 trials scatters by
    // sqrt(2 / 105 / 4000) = 0.2 %; the correction's own error is second order.
    double sum = 0;
    for (int i = 0; i < 4000; ++i) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(i));
        sum += moments(autoregressive(450, 0.8, generator)).variance.value;
    }
    EXPECT_NEAR(sum / 4000, 1, 0.01);
}

TEST(Moments, OfAKnownSample) {
    const Moments m = moments(std::vector<double>{1, 2, 3, 4, 10});
    EXPECT_EQ(m.mean.value, 4);
    EXPECT_EQ(m.samples, 5U);
    // Central moments 10, 36, 278.8.
    EXPECT_NEAR(m.skewness.value, 36 / std::pow(10.0, 1.5), 1e-12);
    EXPECT_NEAR(m.excess_kurtosis.value, 278.8 / 100 - 3, 1e-12);
}

TEST(Moments, OfAnExponentialDistribution) {
    // Skewness 2, excess kurtosis 6, of white noise.
    Count skewness{"skewness"};
    for (int i = 0; i < trials; ++i) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(i));
        std::exponential_distribution<double> exponential;
        std::vector<double> x(4000);
        for (double& v : x) v = exponential(generator);
        skewness.add(moments(x).skewness, 2);
    }
    skewness.expect_coverage("exponential", 0.04);  // the error of a third moment with a long tail
}

TEST(Moments, ConstantRecordHasNoShape) {
    const Moments m = moments(std::vector<double>(50, 0.1));
    EXPECT_EQ(m.mean.value, 0.1);
    EXPECT_EQ(m.variance.value, 0);
    EXPECT_EQ(m.standard_deviation.value, 0);
    EXPECT_TRUE(std::isnan(m.skewness.value));
    EXPECT_TRUE(std::isinf(m.excess_kurtosis.half_width));
    EXPECT_THROW((void)moments(std::vector<double>{1}), InputError);
}

/// Two AR(1) records of correlation r.
std::pair<std::vector<double>, std::vector<double>> correlated(std::size_t n, double phi, double r,
                                                               std::mt19937_64& generator) {
    const std::vector<double> a = autoregressive(n, phi, generator);
    std::vector<double> b = autoregressive(n, phi, generator);
    for (std::size_t i = 0; i < n; ++i) b[i] = r * a[i] + std::sqrt(1 - r * r) * b[i];
    return {a, b};
}

TEST(Covariance, IntervalsCoverTheTruth) {
    for (const double r : {-0.5, 0.0, 0.9}) {
        Count covariances{"covariance"};
        Count correlations{"correlation"};
        for (int i = 0; i < trials; ++i) {
            std::mt19937_64 generator(static_cast<std::uint64_t>(i));
            const auto [a, b] = correlated(2000, 0.9, r, generator);
            const Covariance c = covariance(a, b);
            covariances.add(c.covariance, r);
            correlations.add(c.correlation, r);
        }
        const std::string of = "r " + std::to_string(r);
        covariances.expect_coverage(of, 0.01);
        correlations.expect_coverage(of, 0.01);
    }
}

TEST(Covariance, WithItselfIsTheVariance) {
    std::mt19937_64 generator(3);
    std::vector<double> x = autoregressive(1000, 0.5, generator);
    synthetic::cut_gaps(x, 0.1, 5, generator);
    const Covariance c = covariance(x, x);
    const Moments m = moments(x);
    EXPECT_NEAR(c.covariance.value, m.variance.value, 1e-12);
    EXPECT_NEAR(c.covariance.half_width, m.variance.half_width, 1e-12);
    EXPECT_NEAR(c.correlation.value, 1, 1e-12);
    EXPECT_NEAR(c.correlation.half_width, 0, 1e-12);
}

TEST(Covariance, TakesSamplesThatBothHave) {
    const double gap = std::nan("");
    const Covariance c =
        covariance(std::vector<double>{1, 2, gap, 3, 7}, std::vector<double>{2, 4, 1, 6, gap});
    EXPECT_EQ(c.samples, 3U);
    EXPECT_NEAR(c.correlation.value, 1, 1e-14);
    EXPECT_THROW((void)covariance(std::vector<double>{1, 2}, std::vector<double>{1, 2, 3}), InputError);
}

}  // namespace
}  // namespace riffle::moments_test
