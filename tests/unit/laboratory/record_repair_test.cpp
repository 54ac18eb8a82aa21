#include "laboratory/record_repair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "laboratory/sampling.hpp"
#include "laboratory_file.hpp"
#include "synthetic.hpp"

namespace riffle::record_repair_test {
namespace {

using synthetic::autoregressive;
using ::testing::HasSubstr;
using testing::message_of;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Gaps, AreCountedAndShortOnesInterpolated) {
    std::vector<double> x{nan, 1, nan, 3, nan, nan, nan, 7, nan};
    const Gaps gaps = find_gaps(x);
    EXPECT_EQ(gaps.missing, 6U);
    EXPECT_EQ(gaps.runs, 4U);
    EXPECT_EQ(gaps.longest, 3U);
    EXPECT_EQ(interpolate_gaps(x, 2), 1U);
    EXPECT_EQ(x[2], 2.0);
    EXPECT_TRUE(std::isnan(x[5]));
    EXPECT_EQ(interpolate_gaps(x, 3), 3U);
    EXPECT_EQ(x[5], 5.0);
    EXPECT_TRUE(std::isnan(x.front()));
    EXPECT_TRUE(std::isnan(x.back()));
}

// Each of three ellipses is left by a Gaussian pair with the probability exp(-ln n) = 1/n: three samples of a
// record on average, at most 12 with a probability of 0.99999 (Poisson), whatever its correlation and length;
// passes after the first add fewer.
TEST(Despiking, LeavesCleanRecordsAlone) {
    std::mt19937_64 generator(1);
    for (const double memory : {0.0, 0.8, 0.98}) {
        double sum = 0;
        constexpr int records = 20;
        for (int i = 0; i < records; ++i) {
            const auto spikes = find_spikes(autoregressive(4000, memory, generator));
            EXPECT_LE(spikes.size(), 12U) << memory;
            sum += static_cast<double>(spikes.size());
        }
        std::printf("memory %.2f: %.1f of 4000 taken for spikes\n", memory, sum / records);
        EXPECT_LE(sum / records, 4.5);
    }
}

TEST(Despiking, LeavesSmoothWavesAlone) {
    // Oversampled waves, where value and second difference lie on a line, with and without the last digit.
    for (const double digit : {0.0, 1e-3}) {
        std::vector<double> x;
        for (int i = 0; i < 4000; ++i) {
            const double t = 0.01 * i;
            const double wave =
                std::sin(2 * std::numbers::pi * 1.3 * t) + 0.4 * std::sin(2 * std::numbers::pi * 3.1 * t);
            x.push_back(digit > 0 ? std::round(wave / digit) * digit : wave);
        }
        EXPECT_TRUE(find_spikes(x).empty());
    }
    EXPECT_TRUE(find_spikes(std::vector<double>(1000, 0.25)).empty());
    EXPECT_TRUE(find_spikes(std::vector<double>(1000, nan)).empty());
}

TEST(Despiking, FindsSpikesAndOnlyThem) {
    std::mt19937_64 generator(2);
    std::uniform_real_distribution<double> size(8.0, 12.0);
    for (const double memory : {0.0, 0.8}) {
        std::vector<double> x = autoregressive(5000, memory, generator);
        std::vector<std::size_t> truth;
        for (std::size_t i = 30; i < 4970; i += 97) {
            x[i] += (i % 2 == 0 ? 1 : -1) * size(generator);
            truth.push_back(i);
        }
        x[2500] = nan;  // a gap does not disturb
        const std::vector<std::size_t> found = find_spikes(x);
        const auto missed = std::count_if(truth.begin(), truth.end(), [&](std::size_t i) {
            return !std::binary_search(found.begin(), found.end(), i);
        });
        EXPECT_EQ(missed, 0) << memory;
        EXPECT_LE(found.size(), truth.size() + 12) << memory;
    }
}

// The ends of a long gap in a wave: a line across it has kinks there, which are no spikes.
TEST(Despiking, DoesNotEatIntoARecordFromItsGaps) {
    std::vector<double> x;
    for (int i = 0; i < 2000; ++i) x.push_back(std::sin(2 * std::numbers::pi * 4.0 * 0.01 * i));
    for (std::size_t i = 500; i < 512; ++i) x[i] = nan;
    EXPECT_TRUE(find_spikes(x).empty());
    x[510] = 30.0;  // but a spike beside a gap is one
    EXPECT_EQ(find_spikes(x), (std::vector<std::size_t>{510}));
}

TEST(Repair, CountsWhatItDoes) {
    std::mt19937_64 generator(3);
    std::vector<double> x = autoregressive(1000, 0.9, generator);
    for (std::size_t i = 100; i < 104; ++i) x[i] = nan;
    for (std::size_t i = 400; i < 430; ++i) x[i] = nan;
    x[700] += 20;
    const RecordQuality quality = repair_record(x, {}, 4);
    EXPECT_EQ(quality.samples, 1000U);
    EXPECT_EQ(quality.missing, 30U);
    EXPECT_EQ(quality.refused, 4U);
    EXPECT_EQ(quality.gaps, 2U);
    EXPECT_EQ(quality.longest_gap, 30U);
    EXPECT_GE(quality.spikes, 1U);
    EXPECT_EQ(quality.left, 30U);
    EXPECT_EQ(quality.interpolated, 4 + quality.spikes);
    EXPECT_LT(std::abs(x[700]), 5.0);
    EXPECT_THAT(describe(quality, "P1"),
                HasSubstr("P1: of 1000 samples 30 missing, 4 of poor quality (in 2 gaps"));
    EXPECT_THAT(describe(quality, "P1"), HasSubstr("30 left without a value"));
    EXPECT_EQ(describe(RecordQuality{}, "P1"), "");
}

std::string row_name(std::size_t row) { return "row " + std::to_string(row); }

TEST(Sampling, FindsTheGridThroughRoundingAndLostRows) {
    std::vector<double> times;
    std::vector<double> values;
    for (int i = 0; i < 1000; ++i) {
        if (i >= 300 && i < 305) continue;
        times.push_back(12.0 + std::round(1e3 * i / 150.0) * 1e-3);  // 150 Hz in milliseconds
        values.push_back(i);
    }
    const EvenSampling sampling = find_even_sampling(times, 0.1, row_name);
    // Rounding to 0.5 ms of 1000 times: the slope of a line through them is good to 1e-6.
    EXPECT_NEAR(sampling.frequency, 150.0, 150e-6);
    EXPECT_NEAR(sampling.start, 12.0, 1e-4);
    EXPECT_EQ(sampling.samples, 1000U);
    EXPECT_LT(sampling.largest_departure, 0.08);
    const std::vector<double> even = on_even_grid(sampling, values);
    EXPECT_TRUE(std::isnan(even[302]));
    EXPECT_EQ(even[305], 305.0);
    EXPECT_EQ(even.back(), 999.0);
}

TEST(Sampling, RefusesUnevenTimes) {
    std::vector<double> times{0.0, 0.1, 0.2, 0.35, 0.4, 0.5};
    EXPECT_THAT(message_of([&] { return find_even_sampling(times, 0.1, row_name); }),
                HasSubstr("row 3: the times are not evenly spaced"));
    times[3] = 0.2;
    EXPECT_THAT(message_of([&] { return find_even_sampling(times, 0.1, row_name); }),
                HasSubstr("row 3: expected a time after that of the row before"));
    EXPECT_THAT(message_of([&] { return find_even_sampling({}, 0.1, row_name); }), HasSubstr("at least two"));
}

// A slip of the pen in one time must not ask for more samples than the memory holds.
TEST(Sampling, RefusesATimeThatWouldNeedMoreSamplesThanThereAre) {
    std::vector<double> times;
    for (int i = 0; i < 100; ++i) times.push_back(0.01 * i + (i < 60 ? 0.0 : 1e9));
    EXPECT_THAT(message_of([&] { return find_even_sampling(times, 0.1, row_name); }),
                HasSubstr("row 60: the time goes from 0.59 s to 1e+09 s here"));
    times = {-1e308, 0.0, 1e308};
    EXPECT_THAT(message_of([&] { return find_even_sampling(times, 0.1, row_name); }),
                HasSubstr("correct the time"));
    // Bursts of two minutes each hour are a record.
    times.clear();
    for (int burst = 0; burst < 3; ++burst) {
        for (int i = 0; i < 1200; ++i) times.push_back(3600.0 * burst + 0.1 * i);
    }
    EXPECT_EQ(find_even_sampling(times, 0.1, row_name).samples, 73200U);
}

}  // namespace
}  // namespace riffle::record_repair_test
