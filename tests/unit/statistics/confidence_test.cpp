#include "statistics/confidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "synthetic.hpp"

namespace riffle::confidence_test {
namespace {

TEST(TrustedHalfWidth, IsThatOfTenIndependentSamplesAtLeast) {
    EXPECT_EQ(trusted_half_width(0.25, 10.0), 0.25);
    EXPECT_FALSE(trusted_half_width(0.25, 9.99));
    EXPECT_FALSE(trusted_half_width(MeanEstimate{.half_width = 0.25, .effective_samples = 2.0}));
}

constexpr double truth = 3.0;

/// The record around `truth`.
std::vector<double> autoregressive(std::size_t n, double phi, std::mt19937_64& generator) {
    std::vector<double> x = synthetic::autoregressive(n, phi, generator);
    for (double& v : x) v += truth;
    return x;
}

using synthetic::integral_scale;
using synthetic::share;

struct Record {
    double phi;
    std::size_t n;
};
class Autoregressive : public testing::TestWithParam<Record> {};

// 600 trials of a 95 % interval scatter by 0.9 % (one standard deviation): 92-98 % is three of them.
TEST_P(Autoregressive, IntervalCoversTheMean) {
    const auto [phi, n] = GetParam();
    const double covered = share(600, [&](std::mt19937_64& generator) {
        const MeanEstimate e = mean_with_confidence(autoregressive(n, phi, generator));
        return std::abs(e.mean - truth) <= e.half_width;
    });
    std::printf("phi %.2f n %zu: mean covered %.1f %%\n", phi, n, 100 * covered);
    EXPECT_GE(covered, 0.92);
    EXPECT_LE(covered, 0.98);
}

TEST_P(Autoregressive, IntervalCoversTheTrend) {
    const auto [phi, n] = GetParam();
    const double slope = 1e-3;
    const double covered = share(600, [&](std::mt19937_64& generator) {
        std::vector<double> x = autoregressive(n, phi, generator);
        for (std::size_t i = 0; i < n; ++i) x[i] += slope * static_cast<double>(i);
        const TrendEstimate e = trend_with_confidence(x);
        return std::abs(e.slope - slope) <= e.half_width;
    });
    std::printf("phi %.2f n %zu: trend covered %.1f %%\n", phi, n, 100 * covered);
    EXPECT_GE(covered, 0.92);
    EXPECT_LE(covered, 0.98);
}

TEST_P(Autoregressive, FindsTheIntegralTime) {
    const auto [phi, n] = GetParam();
    double sum = 0;
    constexpr int trials = 200;
    for (int i = 0; i < trials; ++i) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(i));
        sum += mean_with_confidence(autoregressive(n, phi, generator)).integral_time;
    }
    // The largest of the blocked estimates lies above the truth by design.
    EXPECT_GT(sum / trials, 0.90 * integral_scale(phi));
    EXPECT_LT(sum / trials, 1.30 * integral_scale(phi));
}

INSTANTIATE_TEST_SUITE_P(Records, Autoregressive,
                         testing::Values(Record{0.0, 50}, Record{0.0, 3000}, Record{0.5, 400},
                                         Record{0.9, 2000}, Record{0.98, 20000}));

TEST(MeanWithConfidence, WhiteNoiseIsTheTextbookInterval) {
    std::mt19937_64 generator(7);
    const std::vector<double> x = autoregressive(4000, 0.0, generator);
    const MeanEstimate e = mean_with_confidence(x);
    EXPECT_NEAR(e.half_width, 1.96 * e.standard_deviation / std::sqrt(4000.0), 0.25 * e.half_width);
    EXPECT_LE(e.effective_samples, 4000.0);
}

TEST(MeanWithConfidence, FastOscillationDoesNotHideASlowComponent) {
    // Sound or waves on top of slow turbulence: the oscillation has ten times the variance of the rest.
    const double covered = share(300, [](std::mt19937_64& generator) {
        std::vector<double> x = autoregressive(10000, 0.99, generator);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += 4.5 * std::sin(0.7 * static_cast<double>(i));
        const MeanEstimate e = mean_with_confidence(x);
        return std::abs(e.mean - truth) <= e.half_width;
    });
    std::printf("oscillation: covered %.1f %%\n", 100 * covered);
    EXPECT_GE(covered, 0.92);
}

TEST(MeanWithConfidence, LongRecordsAreBlockedWithoutChangingTheAnswer) {
    std::mt19937_64 generator(11);
    const std::vector<double> x = autoregressive(200000, 0.9, generator);
    const MeanEstimate e = mean_with_confidence(x);
    // The bounds of FindsTheIntegralTime.
    EXPECT_GT(e.integral_time, 0.90 * integral_scale(0.9));
    EXPECT_LT(e.integral_time, 1.30 * integral_scale(0.9));
    EXPECT_NEAR(e.standard_deviation, 1.0, 0.05);
}

TEST(MeanWithConfidence, GapsAreLeftOut) {
    // Whole stretches and single samples missing; the band of the coverage test above.
    for (const std::size_t length : {std::size_t{1}, std::size_t{100}}) {
        const double covered = share(600, [&](std::mt19937_64& generator) {
            std::vector<double> x = autoregressive(3000, 0.9, generator);
            synthetic::cut_gaps(x, 0.4, length, generator);
            const MeanEstimate e = mean_with_confidence(x);
            EXPECT_LE(e.effective_samples, 1801);
            return std::abs(e.mean - truth) <= e.half_width;
        });
        std::printf("gaps of %zu: mean covered %.1f %%\n", length, 100 * covered);
        EXPECT_GE(covered, 0.92);
        EXPECT_LE(covered, 0.98);
    }
}

TEST(MeanWithConfidence, ConstantRecordIsExact) {
    const std::vector<double> x(1000, 0.1);
    const MeanEstimate e = mean_with_confidence(x);
    EXPECT_EQ(e.mean, 0.1);
    EXPECT_EQ(e.half_width, 0.0);
    EXPECT_EQ(e.standard_deviation, 0.0);
    const TrendEstimate t = trend_with_confidence(x);
    EXPECT_EQ(t.slope, 0.0);
    EXPECT_EQ(t.half_width, 0.0);
}

TEST(MeanWithConfidence, TooFewSamplesGiveNoConfidence) {
    EXPECT_TRUE(std::isnan(mean_with_confidence({}).mean));
    const std::vector<double> one{2.0};
    EXPECT_EQ(mean_with_confidence(one).mean, 2.0);
    EXPECT_TRUE(std::isinf(mean_with_confidence(one).half_width));
    EXPECT_TRUE(std::isinf(trend_with_confidence(one).half_width));
}

TEST(TrendWithConfidence, ExactLine) {
    std::vector<double> x;
    for (int i = 0; i < 500; ++i) x.push_back(2.0 + 0.25 * i);
    const TrendEstimate t = trend_with_confidence(x);
    EXPECT_NEAR(t.slope, 0.25, 1e-13);
    EXPECT_LT(t.half_width, 1e-12);
}

TEST(TrendWithConfidence, SeesADriftThatMatters) {
    std::mt19937_64 generator(3);
    std::vector<double> x = autoregressive(5000, 0.9, generator);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += 5e-4 * static_cast<double>(i);
    const TrendEstimate t = trend_with_confidence(x);
    EXPECT_GT(t.slope - t.half_width, 0.0);
}

}  // namespace
}  // namespace riffle::confidence_test
