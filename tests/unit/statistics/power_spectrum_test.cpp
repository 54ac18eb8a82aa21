#include "statistics/power_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "statistics/fourier.hpp"
#include "synthetic.hpp"

namespace riffle::power_spectrum_test {
namespace {

using synthetic::autoregressive;

constexpr double interval = 0.02;

/// One-sided density of an AR(1) record of unit variance.
double exact_density(double phi, double frequency) {
    const double angle = 2 * std::numbers::pi * frequency * interval;
    return 2 * interval * (1 - phi * phi) / (1 - 2 * phi * std::cos(angle) + phi * phi);
}

/// Gaussian record whose density is frequency^slope: half of a periodic one with random amplitudes, the
/// lowest frequencies of which are cut off where they would fill the record with a trend.
std::vector<double> power_law_record(std::size_t n, double slope, std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    const std::vector<double> f = one_sided_frequencies(2 * n, interval);
    std::vector<Complex> amplitudes(f.size());
    // density = |X|^2 * 2 interval / (2 n), E|X|^2 = 2 scale^2
    for (std::size_t k = 1; k + 1 < f.size(); ++k) {
        const double scale = std::sqrt(std::pow(f[k], slope) * static_cast<double>(n) / interval / 2);
        amplitudes[k] = {scale * normal(generator), scale * normal(generator)};
    }
    std::vector<double> x = inverse_fourier_transform(amplitudes, 2 * n);
    x.resize(n);
    return x;
}

double integral(const PowerSpectrum& s) {
    return std::accumulate(s.density.begin(), s.density.end(), 0.0) * s.resolution;
}

TEST(PowerSpectrum, OfOneWholeSegmentIntegratesToTheVariance) {
    std::mt19937_64 generator(1);
    for (const std::size_t n : {std::size_t{500}, std::size_t{501}}) {
        std::vector<double> x = autoregressive(n, 0.7, generator);
        double mean = 0;
        for (const double v : x) mean += v / static_cast<double>(n);
        double variance = 0;
        for (const double v : x) variance += (v - mean) * (v - mean) / static_cast<double>(n);
        const PowerSpectrum s = power_spectrum(
            x, interval, {.segment_length = n, .taper = Taper::none, .detrend = Detrend::mean});
        EXPECT_EQ(s.segments, 1U);
        EXPECT_NEAR(integral(s), variance, 1e-12);
        EXPECT_NEAR(s.resolution, 1 / (static_cast<double>(n) * interval), 1e-12);
        EXPECT_NEAR(s.degrees_of_freedom[3], 2, 1e-12);
    }
}

TEST(PowerSpectrum, OfTaperedSegmentsIntegratesToTheVarianceInTheMean) {
    // A line takes two of the 500 degrees of freedom of a segment of white noise. The variance of 200 000
    // samples scatters by sqrt(2/200000) = 0.3 %; overlap and taper leave that nearly so.
    std::mt19937_64 generator(2);
    const PowerSpectrum s =
        power_spectrum(autoregressive(200000, 0, generator), interval, {.segment_length = 500});
    EXPECT_EQ(s.segments, 799U);
    EXPECT_NEAR(integral(s), 1, 3 * 0.004 + 2.0 / 500);
}

TEST(PowerSpectrum, OfASineStandsAtItsFrequencyWithItsPower) {
    // 20.5 cycles in a segment, between two frequencies: the worst place.
    constexpr double amplitude = 3;
    const double frequency = 20.5 / (512 * interval);
    std::vector<double> x(4096);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = amplitude * std::sin(2 * std::numbers::pi * frequency * interval * static_cast<double>(i));
    }
    const PowerSpectrum s = power_spectrum(x, interval, {.segment_length = 512});
    double power = 0;
    for (std::size_t k = 18; k <= 23; ++k) power += s.density[k] * s.resolution;
    // Hann's side lobes beyond three frequencies hold less than 1e-3.
    EXPECT_NEAR(power, amplitude * amplitude / 2, 2e-3 * power);
    EXPECT_LT(s.density[40], 1e-6 * s.density[20]);
}

TEST(PowerSpectrum, HalfOverlappedHannSegmentsHaveWelchsDegreesOfFreedom) {
    // Welch (1967): 2 K / (1 + 2 (1 - 1/K) (1/6)^2) for the correlation 1/6 of half-overlapping Hann tapers.
    const WelchSegments segments(1000 * 8, {.segment_length = 1000});
    ASSERT_EQ(segments.count(), 15U);
    EXPECT_NEAR(segments.degrees_of_freedom(), 30 / (1 + 2 * (1 - 1.0 / 15) / 36), 1e-9);
    const WelchSegments separate(8000, {.segment_length = 1000, .overlap = 0, .taper = Taper::none});
    EXPECT_NEAR(separate.degrees_of_freedom(), 16, 1e-9);
    EXPECT_NEAR(separate.degrees_of_freedom(5), 80, 1e-9);
    // All frequencies of a long record: two for each pair of samples, less what the ripple of the summed
    // squares of the tapers loses, (3/4)^2 / ((3/4)^2 + 1/32) = 18/19, and 1/200 for the ends.
    const WelchSegments many(200000, {.segment_length = 1000});
    EXPECT_NEAR(many.degrees_of_freedom(499) * 500 / 499, 200000 * 18.0 / 19, 0.01 * 200000);
    // Neighbouring Hann densities of one segment: (2/3)^2.
    const WelchSegments one(1000, {.segment_length = 1000});
    EXPECT_NEAR(one.correlation_of_neighbours(), 4.0 / 9, 1e-9);
    // Var(a + b) = Var a + Var b + 2 Cov: a bin of 7 is one of 3 and one of 4.
    const auto variance_of_sum = [&](double m) {
        return m * m / one.degrees_of_freedom(static_cast<std::size_t>(m));
    };
    EXPECT_NEAR(
        variance_of_sum(7),
        variance_of_sum(3) + variance_of_sum(4) +
            2 * one.correlation_of_neighbours(3, 4) * std::sqrt(variance_of_sum(3) * variance_of_sum(4)),
        1e-9);
}

// Densities four frequencies apart are independent; 200 x 30 of them scatter in coverage by 0.3 %.
// 1 % for the chi-square distribution being an approximation for overlapping segments and a sloping spectrum.
TEST(PowerSpectrum, ConfidenceFactorsCoverTheExactSpectrumOfAutoregressiveRecords) {
    for (const double phi : {0.0, 0.8}) {
        int fine = 0;
        int fine_count = 0;
        int smooth = 0;
        int smooth_count = 0;
        for (int i = 0; i < 200; ++i) {
            std::mt19937_64 generator(static_cast<std::uint64_t>(i));
            const SmoothedSpectrum s =
                smoothed_power_spectrum(autoregressive(2400, phi, generator), interval);
            ASSERT_EQ(s.fine.segment_length, 300U);
            const auto covered = [&](const PowerSpectrum& p, std::size_t k) {
                const double truth = exact_density(phi, p.frequency[k]);
                return p.density[k] * p.lower[k] <= truth && truth <= p.density[k] * p.upper[k];
            };
            for (std::size_t k = 4; k + 4 < s.fine.density.size(); k += 4, ++fine_count) {
                fine += covered(s.fine, k) ? 1 : 0;
            }
            // Bins of a single frequency are neighbours; from the tenth frequency on they hold more.
            for (std::size_t k = 10; k < s.smooth.density.size(); ++k, ++smooth_count) {
                smooth += covered(s.smooth, k) ? 1 : 0;
            }
        }
        const double of_fine = static_cast<double>(fine) / fine_count;
        const double of_smooth = static_cast<double>(smooth) / smooth_count;
        std::printf("phi %.1f: densities covered %.2f %% of %d, smoothed ones %.2f %% of %d\n", phi,
                    100 * of_fine, fine_count, 100 * of_smooth, smooth_count);
        EXPECT_NEAR(of_fine, 0.95, 3 * synthetic::share_deviation(0.95, fine_count) + 0.01);
        EXPECT_NEAR(of_smooth, 0.95, 3 * synthetic::share_deviation(0.95, smooth_count / 2) + 0.01);
    }
}

TEST(PowerSpectrum, SmoothingKeepsAWhiteLevelAndNarrowsTheInterval) {
    std::mt19937_64 generator(4);
    const SmoothedSpectrum s = smoothed_power_spectrum(autoregressive(64000, 0, generator), interval);
    const PowerSpectrum& p = s.smooth;
    for (std::size_t k = 0; k < p.density.size(); ++k) {
        // Five standard deviations of a chi-square number.
        EXPECT_NEAR(p.density[k] / (2 * interval), 1, 5 * std::sqrt(2 / p.degrees_of_freedom[k]));
        if (k > 0) {
            EXPECT_GT(p.frequency[k], p.frequency[k - 1]);
        }
    }
    EXPECT_LT(p.upper.back() - p.lower.back(), 0.1);
    EXPECT_GT(p.degrees_of_freedom.back(), 50 * p.degrees_of_freedom.front());
}

TEST(SpectralSlope, IntervalCoversTheSlopeOfAPowerLaw) {
    constexpr int trials = 300;
    for (const double slope : {-5.0 / 3, -1.0}) {
        double mean = 0;
        const double covered = synthetic::share(trials, [&](std::mt19937_64& generator) {
            const std::vector<double> x = power_law_record(4096, slope, generator);
            const SpectralSlope fit = spectral_slope(smoothed_power_spectrum(x, interval).smooth, 0.5, 15);
            mean += fit.slope.value / trials;
            return std::abs(fit.slope.value - slope) <= fit.slope.half_width;
        });
        std::printf("slope %.3f: covered %.1f %%, mean %.4f\n", slope, 100 * covered, mean);
        const double band = 3 * synthetic::share_deviation(0.95, trials);
        EXPECT_GE(covered, 0.95 - band);
        // In one of twenty records the scatter happens to look too large and widens the interval.
        EXPECT_LE(covered, 0.95 + band + 0.05 * 0.05);
    }
}

TEST(SpectralSlope, RecoversTheCoefficientOfAnExactLine) {
    PowerSpectrum s;
    for (int k = 1; k <= 20; ++k) {
        s.frequency.push_back(k);
        s.density.push_back(7 * std::pow(k, -5.0 / 3));
        s.degrees_of_freedom.push_back(1e9);
        s.correlation_with_next.push_back(0);
    }
    const SpectralSlope fit = spectral_slope(s, 2, 15);
    EXPECT_EQ(fit.points, 14U);
    EXPECT_NEAR(fit.slope.value, -5.0 / 3, 1e-9);
    EXPECT_NEAR(fit.coefficient, 7, 1e-7);
}

TEST(SpectralSlope, SaysWhereTheBandIsNoPowerLaw) {
    // The knee of an AR(1) spectrum: the slope goes from 0 to -2.
    std::mt19937_64 generator(6);
    const SmoothedSpectrum s = smoothed_power_spectrum(autoregressive(100000, 0.9, generator), interval);
    EXPECT_GT(spectral_slope(s.smooth, 0.05, 20).reduced_chi_square, 5);
    EXPECT_THROW((void)spectral_slope(s.smooth, 3, 3.1), InputError);
}

TEST(PowerSpectrum, RefusesWhatItCannotDo) {
    std::vector<double> x(100, 1.0);
    x[40] = std::numeric_limits<double>::quiet_NaN();
    try {
        (void)power_spectrum(x, interval);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("sample 41"), std::string::npos) << error.what();
    }
    x[40] = 1;
    EXPECT_THROW((void)power_spectrum(x, interval, {.segment_length = 101}), InputError);
    EXPECT_THROW((void)power_spectrum(x, interval, {.segment_length = 3}), InputError);
    EXPECT_THROW((void)power_spectrum(x, interval, {.overlap = 1}), InputError);
    EXPECT_THROW((void)power_spectrum(x, 0), InputError);
    EXPECT_THROW((void)power_spectrum({}, interval), InputError);
}

}  // namespace
}  // namespace riffle::power_spectrum_test
