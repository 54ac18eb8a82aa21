// The correlation between places in space and time, and the thesis' influence depth that follows from it.

#include "analysis/space_time_correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "synthetic_surface.hpp"

namespace riffle::space_time_correlation_test {
namespace {

constexpr double celerity = 0.3;

/// A pattern of period 0.1 m that travels, as if it were w' at one height.
SpaceTime travelling(double radius, std::uint64_t seed = 1) {
    return travelling_surface({.columns = 40, .spacing = 0.005, .rows = 3000, .interval = 1.0 / 60.0},
                              {.period = 0.1, .correlation_radius = radius, .deviation = 1.0, .seed = seed},
                              celerity);
}

TEST(SpaceTimeCorrelation, OfATravellingPatternIsOneWhereItArrives) {
    const SpaceTimeCorrelation r =
        space_time_correlation(travelling(0.1), {.step = 0.005, .largest_lag = 1.0});
    ASSERT_EQ(r.distance.size(), 40U);
    EXPECT_EQ(r.distance.front(), 0.0);
    EXPECT_NEAR(r.of(0)[0], 1.0, 1e-12);
    for (const std::size_t d : {6UL, 12UL, 30UL}) {
        // A record of 15 m of the pattern: some 80 independent stretches leave a few per cent.
        const LagExtreme extreme = extreme_over_lag(r, d, 1.0);
        EXPECT_NEAR(extreme.correlation, 1.0, 0.05) << d;
        EXPECT_NEAR(extreme.lag, r.distance[d] / celerity, 1.0 / 60.0) << d;
    }
    // At the same time it is Horoshenkov's function (2.32): half a period apart -exp(-1/4).
    EXPECT_NEAR(r.of(10)[0], -std::exp(-0.25), 0.1);
}

TEST(SpaceTimeCorrelation, FollowsAPatternAroundAPeriodicChannel) {
    const SpaceTime around = travelling_surface(
        {.columns = 40, .spacing = 0.005, .periodic = true, .rows = 3000, .interval = 1.0 / 60.0},
        {.period = 0.1, .correlation_radius = 0.1}, celerity);
    EXPECT_NEAR(space_time_correlation(around).distance.back(), 0.1, 1e-12);
    const SpaceTimeCorrelation r = space_time_correlation(around, {.step = 0.005, .largest_distance = 0.195});
    ASSERT_EQ(r.distance.size(), 40U);
    EXPECT_NEAR(extreme_over_lag(r, 30, 0.8).lag, 0.15 / celerity, 1.0 / 60.0);
}

TEST(SpaceTimeCorrelation, RefusesWhatHasNone) {
    SpaceTime flat = travelling(0.1);
    for (std::size_t j = 0; j < flat.rows(); ++j) flat.row(j)[7] = 2.0;
    EXPECT_THROW((void)space_time_correlation(flat), InputError);
    flat.row(3)[0] = std::nan("");
    EXPECT_THROW((void)space_time_correlation(flat), InputError);
}

/// A pattern that turns into its negative after `turn` metres and so passes through zero at half of that. It
/// is correlated over less than a period, so that its other phases make no extremes before.
SpaceTime turning(double turn, std::uint64_t seed) {
    constexpr double radius = 0.035;
    SpaceTime data = travelling(radius, seed);
    const SpaceTime other = travelling(radius, seed + 100);
    for (std::size_t j = 0; j < data.rows(); ++j) {
        const double phase = std::numbers::pi * data.times[j] * celerity / turn;
        for (std::size_t i = 0; i < data.columns; ++i) {
            data.row(j)[i] = data.at(j, i) * std::cos(phase) + other.at(j, i) * std::sin(phase);
        }
    }
    return data;
}

TEST(StreamwiseCorrelation, FindsWhereThePatternChangesItsSign) {
    const CorrelationReach reach{.step = 0.005, .largest_distance = 0.19, .largest_lag = 1.3};
    const StreamwiseCorrelation c = streamwise_correlation(0.04, turning(0.12, 3), reach, celerity, 0.2);
    EXPECT_DOUBLE_EQ(c.extreme.front(), 1.0);
    EXPECT_LT(c.extreme[24], -0.8);  // at 0.12 m
    ASSERT_TRUE(c.zero);
    // At 0.06 m what is correlated before and behind the arrival is as large with either sign, so that the
    // extreme jumps there; the records' errors of some per cent move that by no more than two steps of 5 mm.
    EXPECT_NEAR(*c.zero, 0.06, 0.01);
    const StreamwiseCorrelation none = streamwise_correlation(0.02, travelling(0.1), reach, celerity, 0.25);
    EXPECT_FALSE(none.zero);
}

TEST(StreamwiseCorrelation, UnrelatedPlacesChangeNoSign) {
    SpaceTime noise = travelling(0.1);
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal;
    for (double& value : noise.values) value = normal(generator);
    EXPECT_FALSE(
        streamwise_correlation(0.01, noise, {.step = 0.005, .largest_lag = 1.0}, celerity, 0.25).zero);
}

TEST(DeepestZero, IsTheLastOfTheHeightsGoingDown) {
    const auto height = [](double z, bool zero) {
        StreamwiseCorrelation c;
        c.z = z;
        if (zero) c.zero = 0.1;
        return c;
    };
    EXPECT_EQ(deepest_zero(std::vector{height(0.01, true), height(0.02, false), height(0.03, true),
                                       height(0.04, true)}),
              0.03);
    EXPECT_EQ(deepest_zero(std::vector{height(0.03, true), height(0.04, false)}), std::nullopt);
}

}  // namespace
}  // namespace riffle::space_time_correlation_test
