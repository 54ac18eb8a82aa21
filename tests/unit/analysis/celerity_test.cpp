#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "analysis/celerity_correlation.hpp"
#include "analysis/celerity_ridge.hpp"
#include "analysis/celerity_tracking.hpp"
#include "analysis/gravity_capillary_waves.hpp"
#include "base/error.hpp"
#include "synthetic_surface.hpp"

namespace riffle::celerity_test {
namespace {

// Of 200 intervals of 95 % some 190 +- 3 cover the truth; at least 180 must in each family.
constexpr int trials = 200;
constexpr int least_covered = 180;
constexpr double celerity = 0.3;

/// New patterns pass all the time; a crest moves by half a spacing per interval.
SpaceTime open_line(std::uint64_t seed, double noise, double velocity = celerity) {
    return travelling_surface({.columns = 40, .spacing = 0.01, .rows = 1200, .interval = 1.0 / 60.0},
                              {.period = 0.12, .correlation_radius = 0.09, .noise = noise, .seed = seed},
                              velocity);
}

/// Half of the trials move by half a spacing per interval, where a pattern comes back to the places of the
/// samples, half by a share that does not.
double velocity_of(std::uint64_t seed) { return seed % 2 == 0 ? celerity : 0.2713; }
SpaceTime trial_line(std::uint64_t seed, double noise) { return open_line(seed, noise, velocity_of(seed)); }

/// What trials found.
struct Found {
    int covered = 0;
    double bias = 0, width = 0;  ///< relative

    void add(const Estimate& e, double truth) {
        covered += std::abs(e.value - truth) <= e.half_width ? 1 : 0;
        bias += (e.value / truth - 1.0) / trials;
        width += e.half_width / truth / trials;
    }
    void check(const char* name, double largest_bias) const {
        std::printf("%s: covered %.1f %%, bias %.4f %%, half-width %.4f %%\n", name, 100.0 * covered / trials,
                    100.0 * bias, 100.0 * width);
        EXPECT_NEAR(bias, 0.0, largest_bias) << name;
        EXPECT_GE(covered, least_covered) << name;
    }
};

TEST(CrestTracking, FollowsATravellingSurface) {
    Found clean;
    Found noisy;
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
        const double truth = velocity_of(seed);
        clean.add(track_crests(trial_line(seed, 0.0), {.expected_celerity = 0.25}).celerity, truth);
        const CrestOptions options{.expected_celerity = 0.28, .smoothing = 0.02};
        noisy.add(track_crests(trial_line(seed, 2e-4), options).celerity, truth);
    }
    // The parabola through three points shifts a crest of 12 spacings' wavelength by less than 0.3 % of a
    // spacing; a track is a spacing or more long.
    clean.check("crests", 0.003);
    // The mean of 200 intervals' standard errors of 0.06 %: three of them are 0.013 %.
    noisy.check("crests under noise", 0.00013);
}

TEST(CrestTracking, FollowsPatternsAroundAPeriodicChannel) {
    const SpaceTime surface = travelling_surface(
        {.columns = 40, .spacing = 0.01, .periodic = true, .rows = 600, .interval = 1.0 / 60.0},
        {.period = 0.1, .correlation_radius = 0.2}, celerity);
    const CrestCelerity found = track_crests(surface, {.expected_celerity = 0.28});
    EXPECT_NEAR(found.celerity.value, celerity, 0.003);
    ASSERT_FALSE(found.tracks.empty());
    // 10 s of 0.3 m/s: around the 0.4 m seven times.
    double longest = 0;
    for (const CrestTrack& t : found.tracks) {
        longest = std::max(longest, t.positions.back() - t.positions.front());
    }
    EXPECT_GT(longest, 1.0);
}

TEST(CrestTracking, UpstreamIsNegative) {
    const SpaceTime surface =
        travelling_surface({.columns = 60, .spacing = 0.01, .rows = 600, .interval = 1.0 / 60.0},
                           {.period = 0.12, .correlation_radius = 0.09}, -0.2);
    EXPECT_NEAR(track_crests(surface, {.expected_celerity = -0.15}).celerity.value, -0.2, 0.003);
}

TEST(CrestTracking, WithoutCrestsThereIsNoCelerity) {
    SpaceTime flat = open_line(1, 0.0);
    for (double& v : flat.values) v = 0.0;
    const CrestCelerity found = track_crests(flat, {.expected_celerity = 0.3});
    EXPECT_TRUE(std::isnan(found.celerity.value));
    EXPECT_TRUE(std::isinf(found.celerity.half_width));
    EXPECT_THROW((void)track_crests(block_of_rows(flat, 0, 20), {}), InputError);
}

TEST(StationCelerity, OfATravellingSurface) {
    Found clean, noisy;
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
        clean.add(station_celerity(trial_line(seed, 0.0)).celerity, velocity_of(seed));
        noisy.add(station_celerity(trial_line(seed, 5e-4)).celerity, velocity_of(seed));
    }
    // The parabola through three lags of 1/24 of the pattern's period.
    clean.check("stations", 0.003);
    noisy.check("stations under noise", 0.003);
}

TEST(StationCelerity, LagsOfTheExtremesFollowTheDistance) {
    const StationCelerity found = station_celerity(open_line(3, 3e-4), {.distances = 5});
    ASSERT_EQ(found.stations.size(), 6U);
    EXPECT_EQ(found.used, 5U);
    EXPECT_NEAR(found.stations[0].correlation[found.stations[0].lag.size() / 2], 1.0, 1e-12);
    for (const StationCorrelation& s : found.stations) {
        // 4 mm are 1 % of the line and a tenth of the pattern.
        EXPECT_NEAR(s.extreme_lag.value * celerity, s.distance, 0.004) << s.distance;
        // Noise of 0.3 of the deviation leaves 1/(1 + 0.09) of the correlation. Its share, 0.083, scatters
        // with the variance of some 60 independent samples of surface, by 0.015.
        if (s.distance > 0.0) {
            EXPECT_NEAR(s.extreme_correlation, 1.0 / 1.09, 0.04);
        }
    }
}

TEST(StationCelerity, PatternsThatChangeSignAreFollowed) {
    // Every pattern turns into its negative while it travels 0.12 m: the extreme there is a minimum.
    SpaceTime surface = open_line(5, 0.0);
    const SpaceTime other = open_line(6, 0.0);
    for (std::size_t j = 0; j < surface.rows(); ++j) {
        const double phase = std::numbers::pi * surface.times[j] * celerity / 0.12;
        for (std::size_t i = 0; i < surface.columns; ++i) {
            surface.row(j)[i] = surface.at(j, i) * std::cos(phase) + other.at(j, i) * std::sin(phase);
        }
    }
    const StationCelerity found = station_celerity(surface, {.largest_distance = 0.16, .distances = 16});
    EXPECT_NEAR(found.stations[12].distance, 0.12, 1e-12);
    EXPECT_LT(found.stations[12].extreme_correlation, -0.5);
    EXPECT_NEAR(found.stations[12].extreme_lag.value, 0.12 / celerity, 0.05 * 0.12 / celerity);
}

TEST(StationCelerity, UpstreamIsNegativeAndNoiseHasNone) {
    const SpaceTime upstream =
        travelling_surface({.columns = 60, .spacing = 0.01, .rows = 1200, .interval = 1.0 / 60.0},
                           {.period = 0.12, .correlation_radius = 0.09}, -0.2);
    EXPECT_NEAR(station_celerity(upstream).celerity.value, -0.2, 0.002);
    const SpaceTime noise =
        travelling_surface({.columns = 40, .rows = 4000}, {.deviation = 0.0, .noise = 1e-3}, 0.3);
    EXPECT_TRUE(std::isnan(station_celerity(noise).celerity.value));
    EXPECT_THROW((void)station_celerity(block_of_rows(noise, 0, 30)), InputError);
}

TEST(StationCelerity, APeriodicChannelIsFollowedToHalfItsLength) {
    const SpaceTime surface = travelling_surface(
        {.columns = 40, .spacing = 0.01, .periodic = true, .rows = 2000, .interval = 1.0 / 60.0},
        {.period = 0.1, .correlation_radius = 0.2, .noise = 2e-4}, celerity);
    const StationCelerity found = station_celerity(surface, {.largest_distance = 1.0});
    EXPECT_NEAR(found.stations.back().distance, 0.2, 1e-12);
    EXPECT_NEAR(found.celerity.value, celerity, 0.01 * celerity);
}

/// Records of wave probes at the thesis' places: 0, 28, 120.3 and 300.3 mm, here to the nearest 10 mm.
std::vector<StationRecord> probes(const SpaceTime& line) {
    std::vector<StationRecord> stations;
    for (const std::size_t column : {30UL, 0UL, 3UL, 12UL}) {
        stations.push_back({line.x(column), line.record(column)});
        for (double& v : stations.back().values) v += 0.05;  // a mean level
    }
    return stations;
}

TEST(StationCelerity, OfWaveProbesAtUnevenPlaces) {
    Found found;
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
        const StationCelerity c = station_celerity(probes(trial_line(seed, 3e-4)), 1.0 / 60.0);
        ASSERT_EQ(c.stations.size(), 7U);  // zero and six pairs
        found.add(c.celerity, velocity_of(seed));
    }
    found.check("probes", 0.003);
    std::vector<StationRecord> flat = probes(open_line(1, 0.0));
    for (double& v : flat[2].values) v = 0.05;
    EXPECT_THROW((void)station_celerity(flat, 1.0 / 60.0), InputError);
    flat.resize(1);
    EXPECT_THROW((void)station_celerity(flat, 1.0 / 60.0), InputError);
}

// A regular wave correlates as well with the trough half a period off, and with the crest of another period.
TEST(StationCelerity, OfARegularWaveBetweenGaugesIsItsOwn) {
    constexpr double speed = 1.373;
    constexpr double frequency = 1.0;
    constexpr double interval = 0.02;
    for (const double distance : {0.1, 0.3, 0.45, 0.6}) {
        std::vector<StationRecord> gauges(2);
        for (std::size_t i = 0; i < gauges.size(); ++i) {
            gauges[i].x = static_cast<double>(i) * distance;
            for (int k = 0; k < 3000; ++k) {
                const double phase =
                    2.0 * std::numbers::pi * frequency * (k * interval - gauges[i].x / speed);
                gauges[i].values.push_back(std::cos(phase));
            }
        }
        EXPECT_NEAR(station_celerity(gauges, interval).celerity.value, speed, 0.01 * speed) << distance;
    }
}

TEST(RidgeCelerity, OfATravellingSurface) {
    Found clean, noisy;
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
        clean.add(ridge_celerity(trial_line(seed, 0.0)).celerity, velocity_of(seed));
        noisy.add(ridge_celerity(trial_line(seed, 5e-4)).celerity, velocity_of(seed));
    }
    // Three standard errors of the mean of 200, each 0.13 % under noise.
    clean.check("ridge", 0.0003);
    noisy.check("ridge under noise", 0.0003);
}

TEST(RidgeCelerity, StopsBeforeTheAliases) {
    // At 10 Hz patterns of less than 6 cm are beyond the sampling.
    const SpaceTime surface =
        travelling_surface({.columns = 40, .spacing = 0.01, .rows = 3000, .interval = 0.1},
                           {.period = 0.12, .correlation_radius = 0.03}, celerity);
    const RidgeCelerity found = ridge_celerity(surface);
    EXPECT_LE(found.largest_wavenumber,
              0.8 * found.spectrum.frequency.back() / celerity + found.spectrum.wavenumber_step);
    EXPECT_NEAR(found.celerity.value, celerity, 0.02 * celerity);
}

TEST(RidgeCelerity, OfGravityWavesIsTheirPhaseSpeed) {
    const GravityCapillaryWaves law{.depth = 0.05, .velocity = 0.3};
    for (const bool downstream : {true, false}) {
        const auto omega = [&](double k) {
            return downstream ? law.downstream_frequency(k) : law.upstream_frequency(k);
        };
        const SurfaceGrid grid{
            .columns = 100, .spacing = 0.01, .periodic = true, .rows = 3000, .interval = 0.02};
        const RidgeCelerity found =
            ridge_celerity(synthetic_surface(grid, {.period = 0.15, .correlation_radius = 0.3}, omega, 1.0));
        // Waves of 0.12-0.2 m about the mean one.
        EXPECT_NEAR(found.celerity.value, omega(41.9) / 41.9, 0.01);
        EXPECT_EQ(found.celerity.value > 0.0, downstream);
        for (const RidgePoint& p : found.ridge) {
            EXPECT_NEAR(p.frequency, omega(p.wavenumber), 0.5 * found.spectrum.frequency_step);
        }
    }
}

TEST(RidgeCelerity, OfNoiseIsNotDetermined) {
    SpaceTime noise =
        travelling_surface({.columns = 40, .rows = 4000}, {.deviation = 0.0, .noise = 1e-3}, 0.3);
    const RidgeCelerity found = ridge_celerity(noise, 20);
    EXPECT_TRUE(std::isnan(found.celerity.value) ||
                !(found.celerity.half_width < std::abs(found.celerity.value)));
    EXPECT_THROW((void)ridge_celerity(block_of_rows(noise, 0, 30), 10), InputError);
}

}  // namespace
}  // namespace riffle::celerity_test
