#include "statistics/stationarity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "synthetic.hpp"

namespace riffle::stationarity_test {
namespace {

using synthetic::autoregressive;

/// Reverse arrangements and runs about the median of a permutation of 0 ... n-1, by the definition.
int arrangements(const std::vector<double>& x) {
    int count = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = i + 1; j < x.size(); ++j) count += x[i] > x[j] ? 1 : 0;
    }
    return count;
}

int runs(const std::vector<double>& x) {
    const double median = 0.5 * (static_cast<double>(x.size()) - 1);
    int count = 1;
    for (std::size_t i = 1; i < x.size(); ++i) count += (x[i] > median) != (x[i - 1] > median) ? 1 : 0;
    return count;
}

TEST(Stationarity, PValuesAreThoseOfAllOrders) {
    std::vector<double> x(8);
    std::iota(x.begin(), x.end(), 0.0);
    std::vector<int> by_arrangements(29);
    std::vector<int> by_runs(9);
    std::vector<std::vector<double>> orders;
    int all = 0;
    do {
        ++by_arrangements[static_cast<std::size_t>(arrangements(x))];
        ++by_runs[static_cast<std::size_t>(runs(x))];
        if (all++ % 997 == 0) orders.push_back(x);
    } while (std::next_permutation(x.begin(), x.end()));
    for (const std::vector<double>& order : orders) {
        const int found = arrangements(order);
        const int smaller = std::min(found, 28 - found);
        int tail = 0;
        for (int k = 0; k <= smaller; ++k) tail += by_arrangements[static_cast<std::size_t>(k)];
        EXPECT_NEAR(reverse_arrangements_p_value(order), std::min(1.0, 2.0 * tail / all), 1e-12);
        tail = 0;
        for (int k = 0; k <= runs(order); ++k) tail += by_runs[static_cast<std::size_t>(k)];
        EXPECT_NEAR(runs_p_value(order), static_cast<double>(tail) / all, 1e-12);
    }
    EXPECT_EQ(reverse_arrangements_p_value({}), 1);
    EXPECT_EQ(runs_p_value(std::vector<double>(5, 1.0)), 1);
    EXPECT_EQ(reverse_arrangements_p_value(std::vector<double>(40, 1.0)), 1);
}

TEST(Stationarity, ManyNumbersHaveTheGaussianLimit) {
    // Mean n (n - 1)/4, variance n (2 n + 5) (n - 1)/72; the limit errs by about 1/n of the chance.
    constexpr std::size_t n = 40;
    std::mt19937_64 generator(1);
    for (int i = 0; i < 20; ++i) {
        const std::vector<double> x = autoregressive(n, 0, generator);
        const double z = std::max(std::abs(arrangements(x) - n * (n - 1) / 4.0) - 0.5, 0.0) /
                         std::sqrt(n * (2 * n + 5) * (n - 1) / 72.0);
        EXPECT_NEAR(reverse_arrangements_p_value(x), std::erfc(z / std::numbers::sqrt2), 0.02);
    }
}

// The band is three standard deviations of the share of false alarms; blocks of 20 integral scales are
// correlated by 1/40, which adds to 5 % about 0.5 %.
TEST(Stationarity, RaisesFewFalseAlarmsOnSteadyRecords) {
    constexpr int trials = 500;
    for (const double phi : {0.0, 0.9}) {
        int trend = 0;
        int arrangements_alarms = 0;
        int runs_alarms = 0;
        int variance = 0;
        int all = 0;
        for (int i = 0; i < trials; ++i) {
            std::mt19937_64 generator(static_cast<std::uint64_t>(i));
            const Stationarity s = stationarity(autoregressive(phi > 0 ? 6000 : 1000, phi, generator));
            ASSERT_TRUE(s.blocks);
            trend += s.trend_p_value < 0.05 ? 1 : 0;
            arrangements_alarms += s.blocks->mean_arrangements < 0.05 ? 1 : 0;
            runs_alarms += s.blocks->mean_runs < 0.05 ? 1 : 0;
            variance += s.blocks->variance_arrangements < 0.05 ? 1 : 0;
            all += s.p_value < 0.05 ? 1 : 0;
        }
        const double band = 3 * synthetic::share_deviation(0.05, trials);
        std::printf(
            "phi %.1f: alarms of trend %.1f, arrangements %.1f, runs %.1f, variance %.1f, all %.1f %%\n", phi,
            100.0 * trend / trials, 100.0 * arrangements_alarms / trials, 100.0 * runs_alarms / trials,
            100.0 * variance / trials, 100.0 * all / trials);
        EXPECT_NEAR(static_cast<double>(trend) / trials, 0.05, band);
        for (const int alarms : {arrangements_alarms, runs_alarms, variance, all}) {
            EXPECT_LE(static_cast<double>(alarms) / trials, 0.055 + band);
        }
        EXPECT_GE(static_cast<double>(arrangements_alarms) / trials, 0.05 - band);
    }
}

/// Share of 100 changed AR(1) records of 6000 samples, 316 integral scales, that the test finds.
template <class Change>
double power(const Change& change) {
    return synthetic::share(100, [&](std::mt19937_64& generator) {
        std::vector<double> x = autoregressive(6000, 0.9, generator);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = change(x[i], static_cast<double>(i) / 6000);
        return stationarity(x).p_value < 0.05;
    });
}

// The deviation of the drift's estimate is sqrt(12/316) = 0.19 of the record's: a drift of 1.2 is 6 of them.
TEST(Stationarity, FindsADrift) {
    EXPECT_GE(power([](double x, double t) { return x + 1.2 * t; }), 0.95);
}

// Mean squares of each of 15 blocks scatter by 1/3 of their mean and grow fourfold.
TEST(Stationarity, FindsAGrowingVariance) {
    EXPECT_GE(power([](double x, double t) { return x * (1 + t); }), 0.8);
}

TEST(Stationarity, SaysWhereTheRecordIsTooShort) {
    std::mt19937_64 generator(4);
    const Stationarity s = stationarity(autoregressive(1000, 0.95, generator));
    EXPECT_FALSE(s.blocks);
    EXPECT_LT(s.block_count, 10U);
    EXPECT_EQ(s.p_value, s.trend_p_value);

    // Two periods of a swing are two samples of it: nobody can tell whether it goes on.
    std::vector<double> swing = autoregressive(6000, 0.9, generator);
    for (std::size_t i = 0; i < 6000; ++i) {
        swing[i] += 3 * std::sin(4 * std::numbers::pi * static_cast<double>(i) / 6000);
    }
    EXPECT_FALSE(stationarity(swing).blocks);
}

TEST(Stationarity, OfAnExactLineAndAConstant) {
    std::vector<double> line(200);
    std::iota(line.begin(), line.end(), 0.0);
    const Stationarity s = stationarity(line);
    EXPECT_NEAR(s.drift.value, 200, 1e-9);
    EXPECT_LT(s.trend_p_value, 1e-6);
    EXPECT_EQ(stationarity(std::vector<double>(200, 0.1)).p_value, 1);
    line[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)stationarity(line), InputError);
    EXPECT_THROW((void)stationarity(std::vector<double>(9)), InputError);
}

}  // namespace
}  // namespace riffle::stationarity_test
