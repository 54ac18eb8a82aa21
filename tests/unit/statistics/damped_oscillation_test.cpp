// Damped oscillations of known numbers, with and without noise.

#include "statistics/damped_oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace riffle::damped_oscillation_test {
namespace {

struct Record {
    std::vector<double> time, value;
};

/// 2 s of 0.5 + exp(-0.8 t) (1.5 cos(17 t) - 0.4 sin(17 t)) from t = `start`, with noise of this deviation.
Record record_of(double start, double noise, unsigned seed = 1) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    Record record;
    for (int i = 0; i <= 400; ++i) {
        const double t = start + 0.005 * i;
        record.time.push_back(t);
        record.value.push_back(0.5 +
                               std::exp(-0.8 * t) * (1.5 * std::cos(17.0 * t) - 0.4 * std::sin(17.0 * t)) +
                               (noise > 0.0 ? noise * normal(generator) : 0.0));
    }
    return record;
}

TEST(DampedOscillation, RecoversItsNumbersFromAPoorGuess) {
    for (const double start : {0.0, 1.3}) {
        const Record record = record_of(start, 0.0);
        const auto fit = fit_damped_oscillation(record.time, record.value, 14.0, 0.3);
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->frequency.value, 17.0, 1e-6);
        EXPECT_NEAR(fit->decay.value, 0.8, 1e-6);
        EXPECT_NEAR(fit->offset, 0.5, 1e-7);
        EXPECT_NEAR(fit->cosine, 1.5, 1e-5);
        EXPECT_NEAR(fit->sine, -0.4, 1e-5);
        EXPECT_NEAR(fit->at(record.time[37]), record.value[37], 1e-6);
    }
}

TEST(DampedOscillation, ItsIntervalsHoldTheTruthInNineteenOfTwenty) {
    int frequency_held = 0;
    int decay_held = 0;
    constexpr int records = 200;
    for (unsigned seed = 0; seed < records; ++seed) {
        const Record record = record_of(0.0, 0.2, seed);
        const auto fit = fit_damped_oscillation(record.time, record.value, 16.0, 1.0);
        ASSERT_TRUE(fit);
        frequency_held += fit->frequency.interval.contains(17.0) ? 1 : 0;
        decay_held += fit->decay.interval.contains(0.8) ? 1 : 0;
    }
    // 190 expected; four standard deviations of the count are 12.
    EXPECT_GE(frequency_held, 178);
    EXPECT_GE(decay_held, 178);
    EXPECT_LE(frequency_held + decay_held, 2 * records);
}

TEST(DampedOscillation, OfLessThanAPeriodThereIsNone) {
    Record record = record_of(0.0, 0.0);
    record.time.resize(60);  // 0.3 s of a period of 0.37 s
    record.value.resize(60);
    EXPECT_FALSE(fit_damped_oscillation(record.time, record.value, 17.0, 0.8));
}

}  // namespace
}  // namespace riffle::damped_oscillation_test
