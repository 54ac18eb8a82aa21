// The oscillation that rules a record.

#include "statistics/dominant_frequency.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace riffle::dominant_frequency_test {
namespace {

constexpr double interval = 0.01;  // s

std::vector<double> record(double duration, const std::function<double(double)>& value) {
    std::vector<double> values;
    for (double t = 0.0; t < duration; t += interval) values.push_back(value(t));
    return values;
}

double wave(double frequency, double t) { return std::sin(2.0 * std::numbers::pi * frequency * t + 0.7); }

TEST(DominantOscillation, IsFoundFarWithinTheResolutionOfTheRecord) {
    // 6.3 periods in 2.1 s: the resolution is 0.48 Hz.
    for (const double frequency : {2.9, 3.0, 3.1234}) {
        const auto found = dominant_oscillation(
            record(2.1, [&](double t) { return 5.0 + 0.3 * wave(frequency, t); }), interval, 20.0);
        ASSERT_TRUE(found) << frequency;
        EXPECT_NEAR(found->frequency, frequency, 0.01 / 2.1) << frequency;
        EXPECT_NEAR(found->amplitude, 0.3, 0.01) << frequency;
        EXPECT_GT(found->share, 0.99) << frequency;
        EXPECT_NEAR(found->periods, frequency * 2.1, 0.05) << frequency;
    }
}

TEST(DominantOscillation, DoesNotLookAboveItsLimit) {
    const auto values = record(4.0, [](double t) { return wave(2.0, t) + 3.0 * wave(15.0, t); });
    const auto below = dominant_oscillation(values, interval, 5.0);
    ASSERT_TRUE(below);
    EXPECT_NEAR(below->frequency, 2.0, 0.01);
    EXPECT_GT(below->share, 0.95);
    EXPECT_NEAR(below->whole_share, 0.1, 0.01);  // 1 of 1 + 9
    EXPECT_NEAR(dominant_oscillation(values, interval, 40.0)->frequency, 15.0, 0.01);
}

TEST(DominantOscillation, HasASmallShareOfNoise) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto found =
        dominant_oscillation(record(10.0, [&](double) { return normal(random); }), interval, 40.0);
    ASSERT_TRUE(found);
    EXPECT_LT(found->share, 0.1);  // a lobe of 0.4 Hz of 40, several times the mean
}

TEST(DominantOscillation, IsNotThereInATrendARestOrAFewSamples) {
    EXPECT_FALSE(dominant_oscillation(record(2.0, [](double t) { return t; }), interval, 20.0));
    EXPECT_FALSE(dominant_oscillation(record(2.0, [](double) { return 4.0; }), interval, 20.0));
    EXPECT_FALSE(dominant_oscillation(record(0.1, [](double t) { return wave(30.0, t); }), interval, 40.0));
    EXPECT_FALSE(dominant_oscillation(record(2.0, [](double t) { return wave(3.0, t); }), interval, 0.5));
}

}  // namespace
}  // namespace riffle::dominant_frequency_test
