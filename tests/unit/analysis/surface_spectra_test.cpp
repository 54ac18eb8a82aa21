#include "analysis/surface_spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "analysis/gravity_capillary_waves.hpp"
#include "base/error.hpp"
#include "synthetic_surface.hpp"

namespace riffle::surface_spectra_test {
namespace {

using std::numbers::pi;

double mean_square(const SpaceTime& data) {
    return std::inner_product(data.values.begin(), data.values.end(), data.values.begin(), 0.0) /
           static_cast<double>(data.values.size());
}

/// A single wave cos(k x - omega t).
SpaceTime wave(double k, double omega, std::size_t columns, std::size_t rows, bool periodic) {
    const SurfaceGrid grid{
        .columns = columns, .spacing = 0.01, .periodic = periodic, .rows = rows, .interval = 0.02};
    SpaceTime data = synthetic_surface(
        grid, {.deviation = 0.0}, [](double) { return 0.0; }, 0.0);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            data.row(j)[i] = std::cos(k * data.x(i) - omega * data.times[j]);
        }
    }
    return data;
}

TEST(WavenumberSpectrum, IntegralIsTheVarianceOfAPeriodicLine) {
    for (const std::size_t columns : {40UL, 41UL}) {
        const SpaceTime surface = travelling_surface({.columns = columns, .periodic = true, .rows = 50},
                                                     {.period = 0.1, .noise = 2e-4}, 0.3);
        const WavenumberSpectrum s = wavenumber_spectrum(surface);
        const double integral = std::accumulate(s.density.begin(), s.density.end(), 0.0) * s.step;
        EXPECT_NEAR(integral, mean_square(surface), 1e-12 * integral);
    }
}

TEST(WavenumberSpectrum, OfARandomSurfaceIsTheTransformOfItsCorrelation) {
    const RandomSurface surface{.period = 0.12, .correlation_radius = 0.08};
    const SurfaceGrid grid{.columns = 96, .spacing = 0.01, .rows = 3000, .interval = 0.05};
    const WavenumberSpectrum s = wavenumber_spectrum(travelling_surface(grid, surface, 0.3));
    // The window smooths over two steps of 6.5 rad/m, little beside the width 2/sigma_w = 25 rad/m of the
    // peak.
    int outside = 0, points = 0;
    for (std::size_t i = 4; i < s.wavenumber.size() && s.wavenumber[i] < 90.0; ++i) {
        const double r = surface.correlation_radius, k = s.wavenumber[i], peak = 2 * pi / surface.period;
        const double exact =
            1e-6 * r / (2 * std::sqrt(pi)) * (std::exp(-0.25 * (k - peak) * (k - peak) * r * r));
        // Curvature of the peak times the variance of the squared window's transform: 2 % here.
        outside += std::abs(s.density[i] - exact) > s.half_width[i] + 0.04 * exact ? 1 : 0;
        ++points;
    }
    EXPECT_GE(points, 9);
    EXPECT_LE(outside, 2);
}

TEST(FrequencySpectrum, OfATravellingSurfaceIsThatInWavenumberAtTheCelerity) {
    // S(f) = S(k) dk/df at k = 2 pi f / c. 90 m of surface: 60 densities about the peak, each covered in 95
    // %.
    const RandomSurface surface{.period = 0.12, .correlation_radius = 0.08, .seed = 4};
    const SurfaceGrid grid{.columns = 8, .spacing = 0.01, .rows = 6000, .interval = 0.05};
    const SpaceTime data = travelling_surface(grid, surface, 0.3);
    const FrequencySpectrum s = frequency_spectrum(data, 15);
    int covered = 0, points = 0;
    for (std::size_t m = 2; m < s.frequency.size(); ++m) {
        const double k = 2 * pi * s.frequency[m] / 0.3, r = surface.correlation_radius;
        const double distance = k - 2 * pi / surface.period;
        if (std::abs(distance) > 30.0) continue;
        const double exact =
            1e-6 * r / (2 * std::sqrt(pi)) * std::exp(-0.25 * distance * distance * r * r) * 2 * pi / 0.3;
        covered += std::abs(std::log(s.density[m] / exact)) <= std::log(s.factor[m]) ? 1 : 0;
        ++points;
    }
    std::printf("frequency spectrum: %d of %d densities covered\n", covered, points);
    EXPECT_GE(points, 50);
    // Three standard deviations of the binomial, the neighbours under a Hann window counting for half.
    EXPECT_GE(covered, points * (0.95 - 3 * std::sqrt(0.95 * 0.05 * 2 / points)));
    const double integral = std::accumulate(s.density.begin(), s.density.end(), 0.0) * s.resolution;
    // One sample in 0.06 m: sqrt(2 / 1500) = 3.7 %, more for what the windows leave out.
    EXPECT_NEAR(integral, mean_square(data), 0.12 * integral);
}

TEST(WaveSpectrum, PutsAWaveWhereItBelongs) {
    struct Case {
        double k, omega;
    };
    const double dk = 2 * pi / 0.4;
    const double dw = 2 * pi / (64 * 0.02);
    for (const Case c : {Case{3 * dk, 8 * dw}, Case{-3 * dk, 8 * dw}, Case{5 * dk, 20 * dw}}) {
        const WaveSpectrum s = wave_spectrum(wave(c.k, c.omega, 40, 64, true), 64);
        const auto peak = static_cast<std::size_t>(std::max_element(s.density.begin(), s.density.end()) -
                                                   s.density.begin());
        EXPECT_NEAR(s.wavenumber[peak % 40], c.k, 1e-9) << c.k;
        EXPECT_NEAR(s.frequency[peak / 40], c.omega, 1e-9);
        // The window has the neighbours, at half the amplitude, in time only: 1/(1 + 2/4) of the energy.
        EXPECT_NEAR(s.density[peak] * dk * dw, 0.5 / 1.5, 1e-3);
        EXPECT_NEAR(s.variance(), 0.5, 1e-3);
    }
}

TEST(WaveSpectrum, WavenumbersAscendFromTheNegative) {
    for (const std::size_t columns : {7UL, 8UL}) {
        const WaveSpectrum s = wave_spectrum(wave(1.0, 1.0, columns, 8, true), 8);
        EXPECT_TRUE(std::is_sorted(s.wavenumber.begin(), s.wavenumber.end()));
        EXPECT_NEAR(s.wavenumber.back(), std::floor(static_cast<double>(columns) / 2) * s.wavenumber_step,
                    1e-9);
        EXPECT_EQ(s.wavenumber.size(), columns);
        EXPECT_EQ(s.frequency.size(), 5U);
    }
}

TEST(WaveSpectrum, IntegralIsTheVariance) {
    const SpaceTime surface = travelling_surface({.columns = 64, .rows = 4000}, {.noise = 5e-4}, 0.3);
    const WaveSpectrum s = wave_spectrum(surface, 400);
    // About 80 m of surface with one sample in 0.06 m pass: the windows' weighting scatters by some
    // sqrt(2/1300) = 4 %.
    EXPECT_NEAR(s.variance(), mean_square(surface), 0.12 * s.variance());
    EXPECT_EQ(s.segments, 19U);
}

TEST(WaveSpectrum, GravityWavesLieOnTheDispersionRelation) {
    const GravityCapillaryWaves law{.depth = 0.05, .velocity = 0.3, .surface_tension = 0.072};
    // Waves of 0.05-0.2 m: to 3 rows per period at 0.02 s.
    const SurfaceGrid grid{.columns = 100, .spacing = 0.01, .periodic = true, .rows = 1200, .interval = 0.02};
    for (const bool downstream : {true, false}) {
        const auto omega = [&](double k) {
            return downstream ? law.downstream_frequency(k) : law.upstream_frequency(k);
        };
        const WaveSpectrum s = wave_spectrum(
            synthetic_surface(grid, {.period = 0.1, .correlation_radius = 0.1}, omega, 1.0), 300);
        double on_line = 0.0;
        for (std::size_t m = 0; m < s.frequency.size(); ++m) {
            for (std::size_t i = 0; i < s.wavenumber.size(); ++i) {
                const double k = std::abs(s.wavenumber[i]);
                const double expected = omega(k);
                const double signed_frequency = s.wavenumber[i] < 0 ? -s.frequency[m] : s.frequency[m];
                // The main lobe of the Hann window reaches two steps to each side.
                if (std::abs(signed_frequency - expected) <= 2.0 * s.frequency_step) on_line += s.at(m, i);
            }
        }
        EXPECT_GT(on_line * s.wavenumber_step * s.frequency_step, 0.98 * s.variance()) << downstream;
    }
}

TEST(GravityCapillaryWaves, HasTheKnownLimits) {
    const GravityCapillaryWaves clean{.depth = 0.05, .velocity = 0.2, .surface_tension = 0.072};
    // Long waves: sqrt(g H). Short ones in deep water: the least phase speed 0.23 m/s at 17 mm (Lamb, art.
    // 267).
    EXPECT_NEAR(clean.intrinsic_frequency(0.01) / 0.01, std::sqrt(9.81 * 0.05), 1e-4);
    double least = 1.0, at = 0.0;
    for (double k = 100; k < 1000; k += 1) {
        const double c = clean.intrinsic_frequency(k) / k;
        if (c < least) least = c, at = k;
    }
    EXPECT_NEAR(least, 0.2305, 1e-3);
    EXPECT_NEAR(2 * pi / at, 0.0170, 3e-4);
    EXPECT_DOUBLE_EQ(0.5 * (clean.downstream_frequency(30) + clean.upstream_frequency(30)),
                     clean.advection_frequency(30));
}

TEST(WaveSpectrum, RefusesDryPointsAndUnevenTimes) {
    SpaceTime data = wave(10, 1, 10, 20, true);
    SpaceTime dry = data;
    dry.values[57] = std::nan("");
    EXPECT_THROW((void)wave_spectrum(dry, 20), InputError);
    EXPECT_THROW((void)wavenumber_spectrum(dry), InputError);
    EXPECT_THROW((void)wave_spectrum(data, 21), InputError);
    data.times[7] += 0.005;
    EXPECT_THROW((void)wave_spectrum(data, 20), InputError);
}

}  // namespace
}  // namespace riffle::surface_spectra_test
