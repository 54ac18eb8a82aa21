#include "statistics/settling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "synthetic.hpp"

namespace riffle {
namespace {

using synthetic::autoregressive;

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

TEST(SettlingCurve, IsTheMeanOfTheFirstSamples) {
    std::mt19937_64 generator(1);
    const std::vector<double> x = autoregressive(1003, 0.8, generator);
    const SettlingCurve curve = settling_curve(x, 10);
    ASSERT_EQ(curve.samples.size(), 10U);
    EXPECT_EQ(curve.samples.front(), 100U);
    EXPECT_EQ(curve.samples.back(), 1003U);
    for (std::size_t p = 0; p < 10; ++p) {
        const MeanEstimate mean = mean_with_confidence(std::span(x).first(curve.samples[p]));
        EXPECT_EQ(curve.mean[p], mean.mean);
        EXPECT_EQ(curve.half_width[p], mean.half_width);
    }
    EXPECT_EQ(settling_curve(std::vector<double>{1, 3}).mean, (std::vector<double>{1, 2}));
    EXPECT_THROW((void)settling_curve({}), InputError);
}

TEST(SettledAfter, IsTheFirstSampleAfterWhichTheMeanStays) {
    // Running means 4, 2, 2, 1.5, 1.4, 7/6, 1 of a mean of 1.
    const std::vector<double> x{4, 0, 2, 0, 1, 0, 0};
    EXPECT_EQ(settled_after(x, 10), 1U);
    EXPECT_EQ(settled_after(x, 0.55), 4U);
    EXPECT_EQ(settled_after(x, 0.45), 5U);
    EXPECT_EQ(settled_after(x, 1e-9), 7U);
    // Gaps pass time, and nothing else.
    EXPECT_EQ(settled_after(std::vector<double>{gap, 4, 0, 2, gap, 0, 1, 0, 0}, 0.55), 6U);
    EXPECT_THROW((void)settled_after(x, 0), InputError);
    EXPECT_THROW((void)settled_after(std::vector<double>{gap}, 1), InputError);
}

TEST(SettledAfter, OfAStartUpIsItsAnalyticTime) {
    // exp(-t/T) over 1000 T: the running mean T/t falls to 1/100 (above the final 1/1000) at t = T/0.011.
    constexpr double per_sample = 0.05;
    std::vector<double> x;
    for (int i = 0; i < 20000; ++i) x.push_back(std::exp(-(i + 0.5) * per_sample));
    const double time = static_cast<double>(settled_after(x, 0.01)) * per_sample;
    EXPECT_NEAR(time, 1 / 0.011, 0.1);
}

TEST(TransientLength, CutsAStartUpOff) {
    // Five deviations that decay over 100 samples: the mean of 4000 is off by 0.125, two thirds of its
    // interval.
    constexpr int trials = 200;
    int covered = 0;
    double length = 0;
    for (int i = 0; i < trials; ++i) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(i));
        std::vector<double> x = autoregressive(4000, 0.8, generator);
        for (std::size_t k = 0; k < x.size(); ++k) x[k] += 5 * std::exp(-static_cast<double>(k) / 100);
        const auto cut = transient_length(x);
        ASSERT_TRUE(cut);
        length += static_cast<double>(*cut) / trials;
        const MeanEstimate mean = mean_with_confidence(std::span(x).subspan(*cut));
        covered += std::abs(mean.mean) <= mean.half_width ? 1 : 0;
    }
    std::printf("cut %.0f samples on average, mean of the rest covered in %.1f %%\n", length,
                100.0 * covered / trials);
    // After 160 to 600 samples the start-up is one deviation to 1/80 of it.
    EXPECT_GT(length, 160);
    EXPECT_LT(length, 600);
    // What is left of it, some 2 % of a deviation in the mean, is a quarter of the mean's deviation: 93 %.
    EXPECT_GE(static_cast<double>(covered) / trials, 0.93 - 3 * synthetic::share_deviation(0.93, trials));
}

TEST(TransientLength, OfASteadyRecordIsShortAndOfADriftNone) {
    std::mt19937_64 generator(3);
    const auto steady = transient_length(autoregressive(5003, 0.5, generator));
    ASSERT_TRUE(steady);
    EXPECT_LT(*steady, 1500U);
    std::vector<double> drift = autoregressive(5000, 0.5, generator);
    for (std::size_t i = 0; i < drift.size(); ++i) drift[i] += 0.01 * static_cast<double>(i);
    EXPECT_FALSE(transient_length(drift));
    EXPECT_EQ(transient_length(std::vector<double>(100, 0.1)), 0U);
    EXPECT_THROW((void)transient_length(std::vector<double>(49)), InputError);
}

}  // namespace
}  // namespace riffle
