#include "analysis/space_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "synthetic_surface.hpp"

namespace riffle::space_time_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

SpaceTime small(std::vector<double> times, std::vector<double> values) {
    const std::vector<double> x = {0.1, 0.2, 0.3};
    return make_space_time(x, times, values);
}

template <class F>
std::string message_of(const F& f) {
    try {
        f();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(SpaceTime, RefusesWhatIsNoEvenLine) {
    const std::vector<double> times = {0.0, 1.0};
    const std::vector<double> four(4, 0.0), six(6, 0.0);
    const std::vector<double> even = {0.1, 0.2, 0.3}, uneven = {0.1, 0.2, 0.35}, backwards = {1.0, 0.5};
    EXPECT_NE(message_of([&] { (void)make_space_time(even, times, four); }).find("6 were expected"),
              std::string::npos);
    EXPECT_NE(message_of([&] { (void)make_space_time(uneven, times, six); }).find("x = 0.2 m"),
              std::string::npos);
    EXPECT_NE(message_of([&] { (void)make_space_time(even, backwards, six); }).find("does not follow"),
              std::string::npos);
    EXPECT_NE(message_of([&] { (void)make_space_time(even, times, six, 0.2); }).find("period"),
              std::string::npos);
    EXPECT_TRUE(make_space_time(even, times, six, 0.3).periodic);
}

TEST(SpaceTime, MeanLevelLeavesOutDryPoints) {
    const SpaceTime data = small({0, 1, 2}, {1, 2, nan, 1, 2, nan, 1, 2, nan});
    EXPECT_DOUBLE_EQ(mean_level(data).mean, 1.5);
    EXPECT_DOUBLE_EQ(dry_share(data), 1.0 / 3.0);
    EXPECT_THROW(require_wet(data, "test"), InputError);
}

TEST(SpaceTime, FluctuationRemovesWhatItSays) {
    // Imprint of the bed per column, a trend, a level that sloshes as a whole, and one deviating point.
    SpaceTime data = small({}, {});
    for (int j = 0; j < 4; ++j) {
        data.times.push_back(j);
        for (int i = 0; i < 3; ++i) {
            data.values.push_back(0.1 * i + 0.01 * j * (i + 1) + (j % 2 == 0 ? 0.5 : -0.5));
        }
    }
    const SpaceTime plain = fluctuation(data);
    for (std::size_t i = 0; i < 3; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < 4; ++j) sum += plain.at(j, i);
        EXPECT_NEAR(sum, 0.0, 1e-14);
    }
    const SpaceTime level = fluctuation(data, {.remove_trend = false, .remove_line_mean = true});
    for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_NEAR(level.at(j, 0) + level.at(j, 1) + level.at(j, 2), 0.0, 1e-14);
    }
    // Trend and common motion removed together leave nothing of this record.
    const SpaceTime all = fluctuation(data, {.remove_trend = true, .remove_line_mean = true});
    for (const double v : all.values) EXPECT_NEAR(v, 0.0, 1e-14);
}

TEST(SpaceTime, DeviationOfARandomSurfaceIsCoveredByItsInterval) {
    // 200 trials of a 95 % interval scatter by 1.5 %: 90.4-99.6 % is three standard deviations.
    const SurfaceGrid grid{.columns = 24, .spacing = 0.02, .rows = 500, .interval = 0.05};
    int covered = 0;
    double effective = 0.0;
    constexpr int trials = 200;
    for (int i = 0; i < trials; ++i) {
        RandomSurface surface{.period = 0.15, .correlation_radius = 0.1};
        surface.seed = static_cast<std::uint64_t>(100 + i);
        const DeviationEstimate found =
            standard_deviation(fluctuation(travelling_surface(grid, surface, 0.3)));
        covered += std::abs(found.value - surface.deviation) <= found.half_width ? 1 : 0;
        effective += found.effective_samples / trials;
    }
    std::printf("standard deviation: covered %.1f %%, %.0f effective samples\n", 100.0 * covered / trials,
                effective);
    EXPECT_GE(covered, 181);
    // The surface passes 7.5 m; the variance of a mean square knows integral W^2 = sqrt(pi/8) sigma_w (times
    // one half each side, the cosine's oscillation aside) per sample: 7.5 / 0.063 = 120.
    EXPECT_GT(effective, 60.0);
    EXPECT_LT(effective, 240.0);
}

TEST(SpaceTime, ResamplingFollowsAWaveThroughJitter) {
    // Times late by up to 0.3 intervals; a wave of 20 intervals. Cubic interpolation errs by at most
    // (9/384) (omega dt)^4 of the amplitude for even points, less than 3 times that for these: 7e-4.
    const double interval = 0.01;
    const double omega = 2.0 * std::numbers::pi / (20.0 * interval);
    SpaceTime data = small({}, {});
    for (int j = 0; j < 400; ++j) {
        const double t = interval * (j + 0.15 * (1.0 + std::sin(12.9898 * j)));
        data.times.push_back(t);
        for (int i = 0; i < 3; ++i) data.values.push_back(std::sin(omega * t + i));
    }
    const SpaceTime even = resample_evenly(data);
    EXPECT_NEAR(sampling_interval(data), interval, 0.2 * interval);
    ASSERT_NO_THROW(require_even_times(even, "test", 1e-9));
    EXPECT_EQ(even.times.back(), data.times.back());
    for (std::size_t j = 2; j + 2 < even.rows(); ++j) {
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(even.at(j, i), std::sin(omega * even.times[j] + static_cast<double>(i)), 7e-4);
        }
    }
}

// Samples at the first step after their time, thirty steps an interval: even times at the median interval, a
// step more than the mean at times, would drift through them, and half-way between samples white noise keeps
// 0.8 of its size.
TEST(SpaceTime, ResamplingKeepsTheSizeOfNoise) {
    const double step = 0.01 / 30.3;
    SpaceTime data = small({}, {});
    std::mt19937 random(3);
    std::normal_distribution<double> noise;
    for (int j = 1; j <= 3000; ++j) {
        data.times.push_back(step * std::ceil(0.01 * j / step));
        for (int i = 0; i < 3; ++i) data.values.push_back(noise(random));
    }
    const SpaceTime even = resample_evenly(data);
    EXPECT_EQ(even.rows(), data.rows());
    EXPECT_NEAR(standard_deviation(even).value, standard_deviation(data).value, 0.01);
}

TEST(SpaceTime, ResamplingKeepsTheIntervalWhereASampleIsMissing) {
    SpaceTime data = small({}, {});
    for (int j = 0; j < 100; ++j) {
        if (j == 40) continue;
        data.times.push_back(0.5 * j);
        data.values.insert(data.values.end(), 3, 1.0);
    }
    EXPECT_NEAR(sampling_interval(data), 0.5, 1e-12);
    EXPECT_EQ(resample_evenly(data, 4.0).rows(), 100U);
}

TEST(SpaceTime, ResamplingRefusesAGapAndNamesIt) {
    const SpaceTime data = small({0, 1, 2, 5, 6}, std::vector<double>(15, 0.0));
    const std::string message = message_of([&] { (void)resample_evenly(data); });
    EXPECT_NE(message.find("between 2 s and 5 s"), std::string::npos) << message;
    EXPECT_NO_THROW((void)resample_evenly(data, 4.0));
}

TEST(SpaceTime, ResamplingKeepsDryPointsDry) {
    SpaceTime data = small({0, 1, 2, 3, 4, 5}, std::vector<double>(18, 2.0));
    data.values[2 * 3 + 1] = nan;
    const SpaceTime even = resample_evenly(data);
    for (std::size_t j = 0; j < 6; ++j) {
        EXPECT_EQ(std::isnan(even.at(j, 1)), j == 2);
        EXPECT_NEAR(even.at(j, 0), 2.0, 1e-12);
    }
}

TEST(SpaceTimes, FewerColumnsOfAnyNumberKeepThePeriod) {
    for (const std::size_t columns : {521UL, 1040UL, 1021UL, 600UL}) {  // primes among them
        SpaceTime data;
        data.columns = columns;
        data.spacing = 1.0 / static_cast<double>(columns);
        data.periodic = true;
        data.times = {0.0};
        for (std::size_t i = 0; i < columns; ++i) {
            data.values.push_back(std::sin(2.0 * std::numbers::pi * data.x(i)));
        }
        const SpaceTime fewer = fewer_columns(data, 512);
        EXPECT_LE(fewer.columns, 512U) << columns;
        EXPECT_GE(fewer.columns, 256U) << columns;
        EXPECT_NEAR(fewer.length(), data.length(), 1e-12) << columns;
        ASSERT_EQ(fewer.values.size(), fewer.columns);
        // Linear interpolation between columns: (2 pi dx)^2/8.
        const double error = std::pow(2.0 * std::numbers::pi * data.spacing, 2) / 8.0;
        for (std::size_t i = 0; i < fewer.columns; ++i) {
            EXPECT_NEAR(fewer.at(0, i), std::sin(2.0 * std::numbers::pi * fewer.x(i)), error + 1e-12);
        }
    }
}

}  // namespace
}  // namespace riffle::space_time_test
