#include "statistics/settling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "synthetic.hpp"

namespace riffle::settling_test {
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

}  // namespace
}  // namespace riffle::settling_test
