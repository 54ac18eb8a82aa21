#include "ends/recorded_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace riffle::recorded_flow_test {
namespace {

constexpr double length = 0.3;
constexpr double width = 0.2;
constexpr double two_pi = 2.0 * std::numbers::pi;

/// A record of u(moment, x, y, z/H), v and w a half and a third of what it departs from `mean`.
RecordedWater record(const std::vector<double>& time, const std::function<double(double)>& mean,
                     const std::function<double(std::size_t, double, double, double)>& departure) {
    RecordedWater water;
    water.length = length;
    water.width = width;
    water.cells = {60, 20, 10};
    water.time = time;
    const auto [nx, ny, nz] = water.cells;
    for (std::size_t moment = 0; moment < time.size(); ++moment) {
        std::vector<float> values;
        for (std::size_t cell = 0; cell < nx * ny * nz; ++cell) {
            const auto middle = [](std::size_t index, std::size_t cells) {
                return (static_cast<double>(index) + 0.5) / static_cast<double>(cells);
            };
            const double place = middle(cell / (nx * ny), nz);
            const double d =
                departure(moment, length * middle(cell % nx, nx), width * middle(cell / nx % ny, ny), place);
            values.push_back(static_cast<float>(mean(place) + d));
            values.push_back(static_cast<float>(0.5 * d));
            values.push_back(static_cast<float>(d / 3.0));
        }
        water.velocity.push_back(std::move(values));
    }
    return water;
}

double profile(double place) { return 0.2 + 0.4 * place; }  // mean 0.4
constexpr double bulk = 0.4;

/// Eddies that the mean flow carries along.
double eddy(double x, double y, double place, double time) {
    return 0.05 * std::sin(two_pi * (x - profile(place) * time) / length) * std::cos(two_pi * y / width);
}

// At every moment, not the recorded ones alone, and at any place: what comes down the channel.
TEST(RecordedFlow, CarriesTheEddiesAlong) {
    const std::vector<double> time{10.0, 10.2, 10.3, 10.6};
    const RecordedFlow flow(record(time, profile, [&](std::size_t moment, double x, double y, double place) {
        return eddy(x, y, place, time[moment] - time[0]);
    }));
    EXPECT_NEAR(flow.bulk_velocity(), bulk, 1e-6);
    for (const double t : {0.0, 0.07, 0.2, 0.29, 0.45, 0.6}) {
        for (const double y : {0.01, 0.06, 0.13, 0.199, 0.06 + width}) {
            for (const double place : {0.15, 0.5, 0.85}) {
                const double expected = eddy(0.0, y, place, t);
                const Vec<3> u = flow.at(t, y, place);
                // Between two rows the shear has carried the eddies of one an eighth of a turn from the
                // other's.
                EXPECT_NEAR(u[0] * bulk, profile(place) + expected, 0.003) << t << " " << y << " " << place;
                EXPECT_NEAR(u[1] * bulk, 0.5 * expected, 0.0015);
                EXPECT_NEAR(u[2] * bulk, expected / 3.0, 0.001);
            }
        }
    }
    EXPECT_NEAR(flow.mean_at(0.05, 0.5), 1.0, 1e-5);
    EXPECT_NEAR(flow.largest() * bulk, profile(0.95), 1e-5);
    EXPECT_NEAR(flow.fastest() * bulk, profile(0.95) + 0.05, 0.002);
}

/// Mean square of the velocity that enters, at a share of the way from each moment to the next.
double mean_square(const RecordedFlow& flow, double interval, int moments, double share) {
    double sum = 0.0;
    int count = 0;
    for (int moment = 0; moment < moments; ++moment) {
        for (int iy = 0; iy < 200; ++iy) {
            for (int iz = 0; iz < 9; ++iz) {
                const double place = (iz + 0.5) / 10.0;
                const double y = width * (iy + 0.5) / 200;
                const double d = flow.at((moment + share) * interval, y, place)[0] - flow.mean_at(y, place);
                sum += d * d * bulk * bulk;
                ++count;
            }
        }
    }
    return sum / count;
}

// Moments that know nothing of each other: half of either would have half of the mean square.
TEST(RecordedFlow, KeepsTheMeanSquareBetweenMoments) {
    constexpr int moments = 24;
    constexpr double interval = 1.0;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> phase(0.0, two_pi);
    std::vector<double> time;
    std::vector<std::array<double, 2>> phases;
    for (int i = 0; i < moments; ++i) {
        time.push_back(interval * i);
        phases.push_back({phase(random), phase(random)});
    }
    const RecordedFlow flow(
        record(time, profile, [&](std::size_t moment, double x, double y, double /*place*/) {
            return 0.05 * std::sin(two_pi * x / length + phases[moment][0]) *
                   std::sin(two_pi * y / width + phases[moment][1]);
        }));
    const double recorded = 0.05 * 0.05 / 4.0;
    for (const double share : {0.01, 0.25, 0.5, 0.75}) {
        // The places x of a moment that enter are one for each height: a mean over 24 moments and 9 heights.
        EXPECT_NEAR(mean_square(flow, interval, moments, share), recorded, 0.2 * recorded) << share;
    }
}

TEST(RecordedFlow, RepeatsWithoutAJump) {
    const std::vector<double> time{3.0, 3.5, 4.0};
    const RecordedFlow flow(record(time, profile, [](std::size_t moment, double x, double y, double place) {
        return eddy(x + 0.1 * static_cast<double>(moment), y, place, 0.0);
    }));
    EXPECT_NEAR(flow.period(), 1.5, 1e-12);
    for (const double t : {0.0, 0.5, 1.0, 1.5}) {
        const double before = flow.at(t + 1.5 - 1e-9, 0.03, 0.5)[0];
        EXPECT_NEAR(flow.at(t + 1e-9, 0.03, 0.5)[0], before, 1e-6) << t;
        EXPECT_NEAR(flow.at(t + 3.0 + 1e-9, 0.03, 0.5)[0], before, 1e-6);
    }
}

// Multiples of the period, a little less by rounding.
TEST(RecordedFlow, IsThereAtEachMultipleOfItsPeriod) {
    const RecordedFlow flow(record({0.0, 0.05}, profile, [](std::size_t, double x, double y, double place) {
        return eddy(x, y, place, 0.0);
    }));
    for (int i = 0; i < 2000; ++i) {
        const double u = flow.at(0.1 * i, 0.03, 0.5)[0];
        EXPECT_NEAR(u, flow.at(0.0, 0.03, 0.5)[0], 1e-6) << i;
    }
}

// One moment alone: the frozen water goes by.
TEST(RecordedFlow, ASingleMomentIsCarriedAlong) {
    const RecordedFlow flow(record(
        {2.0}, [](double) { return bulk; },
        [](std::size_t, double x, double, double) { return 0.05 * std::sin(two_pi * x / length); }));
    EXPECT_NEAR(flow.period(), length / bulk, 1e-6);
    for (const double t : {0.0, 0.1, 0.3, 1.0}) {
        EXPECT_NEAR(flow.at(t, 0.1, 0.5)[0] * bulk, bulk + 0.05 * std::sin(two_pi * (-bulk * t) / length),
                    0.001);
    }
}

// Between side walls the mean differs across the channel, and the water does not go on beyond them.
TEST(RecordedFlow, BetweenSideWallsTheMeanIsThatOfEachPlace) {
    RecordedWater water = record({0.0, 1.0}, profile, [](std::size_t, double, double y, double) {
        return 0.1 * std::sin(std::numbers::pi * y / width);
    });
    water.repeats_across = false;
    const RecordedFlow flow(std::move(water));
    EXPECT_GT(flow.mean_at(0.5 * width, 0.5), flow.mean_at(0.01 * width, 0.5) + 0.15);
    EXPECT_EQ(flow.mean_at(-0.01, 0.5), flow.mean_at(0.0, 0.5));
    const std::vector<double> files{0.025, 0.075, 0.125, 0.175};
    EXPECT_NEAR(flow.mean_of_streams(0.3, 40, files), 1.0, 0.01);
}

}  // namespace
}  // namespace riffle::recorded_flow_test
