#include "statistics/cross_correlation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "statistics/cross_spectrum.hpp"
#include "statistics/power_spectrum.hpp"
#include "synthetic.hpp"

namespace riffle::cross_correlation_test {
namespace {

using synthetic::autoregressive;

constexpr double interval = 0.01;
using std::numbers::pi;

/// By the definition, pair by pair.
double direct(const std::vector<double>& a, const std::vector<double>& b, long lag, LagDivisor divisor) {
    const auto moments_of = [](const std::vector<double>& x) {
        double mean = 0;
        double count = 0;
        double square = 0;
        for (const double v : x) {
            if (!std::isnan(v)) mean += v, ++count;
        }
        mean /= count;
        for (const double v : x) {
            if (!std::isnan(v)) square += (v - mean) * (v - mean);
        }
        return std::pair{mean, std::pair{count, square}};
    };
    const auto [mean_a, of_a] = moments_of(a);
    const auto [mean_b, of_b] = moments_of(b);
    double sum = 0;
    double pairs = 0;
    for (long t = 0; t < static_cast<long>(a.size()); ++t) {
        if (t + lag < 0 || t + lag >= static_cast<long>(b.size())) continue;
        const double u = a[static_cast<std::size_t>(t)];
        const double v = b[static_cast<std::size_t>(t + lag)];
        if (!std::isnan(u) && !std::isnan(v)) sum += (u - mean_a) * (v - mean_b), ++pairs;
    }
    const double counts = std::sqrt(of_a.first * of_b.first);
    const double scale = std::sqrt(of_a.second * of_b.second) / counts;
    return sum / (divisor == LagDivisor::unbiased ? pairs : counts) / scale;
}

TEST(CrossCorrelation, IsTheMeanOverPairsWithAndWithoutGaps) {
    std::mt19937_64 generator(1);
    for (const bool gaps : {false, true}) {
        std::vector<double> a = autoregressive(200, 0.7, generator);
        std::vector<double> b = autoregressive(200, 0.9, generator);
        if (gaps) {
            synthetic::cut_gaps(a, 0.2, 5, generator);
            synthetic::cut_gaps(b, 0.1, 9, generator);
        }
        for (const LagDivisor divisor : {LagDivisor::biased, LagDivisor::unbiased}) {
            const CrossCorrelation r = cross_correlation(a, b, interval, 150, divisor);
            for (long lag = -150; lag <= 150; ++lag) {
                const auto i = static_cast<std::size_t>(lag + 150);
                ASSERT_NEAR(r.lag[i], static_cast<double>(lag) * interval, 1e-12);
                ASSERT_NEAR(r.correlation[i], direct(a, b, lag, divisor), 1e-12) << "lag " << lag;
            }
        }
    }
}

TEST(CrossCorrelation, PeaksAtTheTimeByWhichTheSecondFollows) {
    // b(t) = a(t - 0.237 s) of a smooth a: a sum of sines up to 4 Hz, so a parabola over +-0.01 s errs in its
    // place by well below a tenth of a sample.
    std::mt19937_64 generator(2);
    std::uniform_real_distribution<double> uniform;
    std::vector<double> frequency(40);
    std::vector<double> phase(40);
    for (double& f : frequency) f = 4 * uniform(generator);
    for (double& p : phase) p = 2 * pi * uniform(generator);
    const auto signal = [&](double t) {
        double sum = 0;
        for (std::size_t k = 0; k < 40; ++k) sum += std::cos(2 * pi * frequency[k] * t + phase[k]);
        return sum;
    };
    std::vector<double> a;
    std::vector<double> b;
    for (int i = 0; i < 4000; ++i) {
        a.push_back(signal(i * interval));
        b.push_back(-signal(i * interval - 0.237));  // upside down: a minimum
    }
    const CrossCorrelation r = cross_correlation(a, b, interval, 100);
    const std::vector<CorrelationExtreme> extremes = correlation_extremes(r);
    const auto lowest = std::min_element(extremes.begin(), extremes.end(), [](const auto& p, const auto& q) {
        return p.correlation < q.correlation;
    });
    ASSERT_NE(lowest, extremes.end());
    EXPECT_FALSE(lowest->maximum);
    EXPECT_TRUE(lowest->significant);
    EXPECT_NEAR(lowest->lag, 0.237, 0.1 * interval);
    EXPECT_NEAR(lowest->correlation, -1, 0.02);  // other pairs of samples at each lag: 24 of 4000
}

TEST(CrossCorrelation, ExtremesAreThoseOfACosine) {
    CrossCorrelation r;
    for (int i = -100; i <= 100; ++i) {
        r.lag.push_back(0.1 * i);
        r.correlation.push_back(0.5 * std::cos(0.1 * i - 1.234));
        r.significance.push_back(0.4);
    }
    const std::vector<CorrelationExtreme> extremes = correlation_extremes(r);
    ASSERT_EQ(extremes.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        // The parabola errs by the next term of the cosine, of order step^3/50.
        EXPECT_NEAR(extremes[i].lag, 1.234 + pi * (static_cast<double>(i) - 3), 1e-4);
        EXPECT_EQ(extremes[i].maximum, i % 2 == 1);
        EXPECT_NEAR(std::abs(extremes[i].correlation), 0.5, 1e-5);
        EXPECT_TRUE(extremes[i].significant);
    }
}

// 600 trials of 5 %: 2.7 % is three standard deviations; the correlations in time being estimated, one in 20
// more.
TEST(CrossCorrelation, UnrelatedRecordsExceedTheSignificanceInOneOfTwentyTrials) {
    constexpr int trials = 600;
    for (const auto& [phi_a, phi_b, missing] : {std::array{0.0, 0.0, 0.0}, std::array{0.9, 0.9, 0.0},
                                                std::array{0.95, 0.5, 0.0}, std::array{0.9, 0.9, 0.25}}) {
        const double exceeded = synthetic::share(trials, [&](std::mt19937_64& generator) {
            std::vector<double> a = autoregressive(900, phi_a, generator);
            const std::vector<double> b = autoregressive(900, phi_b, generator);
            synthetic::cut_gaps(a, missing, 10, generator);
            const CrossCorrelation r = cross_correlation(a, b, interval, 10);
            return std::abs(r.correlation[3]) > r.significance[3];
        });
        std::printf("phi %.2f and %.2f: exceeded in %.1f %%\n", phi_a, phi_b, 100 * exceeded);
        EXPECT_NEAR(exceeded, 0.05, 3 * synthetic::share_deviation(0.05, trials) + 0.0025);
    }
}

TEST(CrossCorrelation, RefusesWhatItCannotDo) {
    const std::vector<double> x{1, 2, 4};
    EXPECT_THROW((void)cross_correlation(x, std::vector<double>{1, 2}, interval, 1), InputError);
    EXPECT_THROW((void)cross_correlation(x, x, interval, 3), InputError);
    EXPECT_THROW((void)cross_correlation(x, x, 0, 1), InputError);
    EXPECT_THROW((void)cross_correlation(x, std::vector<double>{1, 1, 1}, interval, 1), InputError);
}

/// White a, and b = a/2 seven samples later with noise of the same power: coherence 1/2.
std::pair<std::vector<double>, std::vector<double>> delayed(std::size_t n, std::mt19937_64& generator) {
    std::vector<double> a = autoregressive(n + 7, 0, generator);
    std::vector<double> b = autoregressive(n, 0, generator);
    for (std::size_t i = 0; i < n; ++i) b[i] = 0.5 * (a[i] + b[i]);
    a.erase(a.begin(), a.begin() + 7);
    return {a, b};
}

TEST(CrossSpectrum, FindsCoherenceAndDelay) {
    std::mt19937_64 generator(3);
    const auto [a, b] = delayed(512 * 100, generator);
    const CrossSpectrum s = cross_spectrum(a, b, interval, {.segment_length = 512});
    const PowerSpectrum p = power_spectrum(b, interval, {.segment_length = 512});
    int inside = 0;
    int count = 0;
    double coherence = 0;
    for (std::size_t k = 2; k < 254; ++k) {
        EXPECT_NEAR(s.density_b[k], p.density[k], 1e-12);
        coherence += s.coherence[k] / 252;
        if (k % 4 != 0) continue;  // independent ones
        const double error = std::remainder(s.phase[k] - 2 * pi * s.frequency[k] * 7 * interval, 2 * pi);
        inside += std::abs(error) <= s.phase_half_width[k] ? 1 : 0;
        ++count;
    }
    // Mean over 126 independent frequencies of a deviation sqrt(2 c) (1 - c)/sqrt(189 segments); bias 1/189
    // and the part of the segments that the delay moves out of them, (7/512)^2 pi^2.
    EXPECT_NEAR(coherence, 0.5, 3 * 0.5 / std::sqrt(189.0 * 126) + 0.006);
    EXPECT_GE(static_cast<double>(inside) / count, 0.95 - 3 * synthetic::share_deviation(0.95, count));
}

TEST(CrossSpectrum, UnrelatedRecordsExceedTheSignificanceInOneOfTwentyFrequencies) {
    int exceeded = 0;
    int count = 0;
    for (int i = 0; i < 60; ++i) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(i));
        const std::vector<double> a = autoregressive(4000, 0.5, generator);
        const std::vector<double> b = autoregressive(4000, 0.8, generator);
        const CrossSpectrum s = cross_spectrum(a, b, interval, {.segment_length = 400});
        for (std::size_t k = 4; k < 198; k += 4, ++count) {
            exceeded += s.coherence[k] > s.coherence_significance ? 1 : 0;
            EXPECT_EQ(s.phase_half_width[k] == pi, s.coherence[k] <= s.coherence_significance);
        }
    }
    const double share = static_cast<double>(exceeded) / count;
    std::printf("coherence of unrelated records exceeded in %.1f %% of %d\n", 100 * share, count);
    // Overlapping segments are not quite as many independent ones: 1 %.
    EXPECT_NEAR(share, 0.05, 3 * synthetic::share_deviation(0.05, count) + 0.01);
}

TEST(CrossSpectrum, RefusesWhatItCannotDo) {
    const std::vector<double> x(64, 1.0);
    EXPECT_THROW((void)cross_spectrum(x, x, interval, {.segment_length = 64}), InputError);
    EXPECT_THROW((void)cross_spectrum(x, std::vector<double>(63), interval), InputError);
}

}  // namespace
}  // namespace riffle::cross_correlation_test
