#include "analysis/surface_correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "base/error.hpp"
#include "synthetic_surface.hpp"

namespace riffle::surface_correlation_test {
namespace {

/// A correlation that is the function itself, in `blocks` equal blocks.
SpatialCorrelation exact(double l0, double radius, double share, std::size_t lags, double spacing) {
    SpatialCorrelation c;
    c.blocks = 4;
    for (std::size_t i = 0; i < lags; ++i) {
        c.distance.push_back(static_cast<double>(i) * spacing);
        c.correlation.push_back((i == 0 ? 1.0 : share) * horoshenkov_correlation(c.distance[i], l0, radius));
    }
    for (std::size_t b = 0; b < c.blocks; ++b) {
        c.block_covariance.insert(c.block_covariance.end(), c.correlation.begin(), c.correlation.end());
    }
    return c;
}

TEST(SurfaceCorrelation, FitFindsTheFunctionItself) {
    for (const double l0 : {0.08, 0.15, 0.3}) {
        for (const double radius : {0.05, 0.2}) {
            for (const double share : {1.0, 0.7}) {
                const auto fit = fit_surface_correlation(exact(l0, radius, share, 60, 0.005));
                EXPECT_NEAR(fit.characteristic_period.value, l0, 1e-5) << l0 << ' ' << radius;
                EXPECT_NEAR(fit.correlation_radius.value, radius, 1e-5);
                EXPECT_NEAR(fit.correlated_share.value, share, 1e-5);
                EXPECT_LT(fit.residual, 1e-6);
            }
        }
    }
}

TEST(SurfaceCorrelation, WithoutNoiseTheShareIsOne) {
    const auto fit = fit_surface_correlation(exact(0.1, 0.1, 1.0, 60, 0.005), {.white_noise = false});
    EXPECT_NEAR(fit.characteristic_period.value, 0.1, 1e-5);
    EXPECT_EQ(fit.correlated_share.value, 1.0);
    EXPECT_EQ(fit.correlated_share.half_width, 0.0);
}

TEST(SurfaceCorrelation, APeriodBeyondTheLineIsNotDetermined) {
    const auto fit = fit_surface_correlation(exact(5.0, 4.0, 1.0, 20, 0.005));
    EXPECT_TRUE(std::isnan(fit.characteristic_period.value));
    EXPECT_TRUE(std::isinf(fit.characteristic_period.half_width));
}

TEST(SurfaceCorrelation, APeriodBelowTheResolutionIsNotDetermined) {
    // Neighbouring points of opposite sign: rows of particles, not patterns.
    const SurfaceGrid grid{.columns = 60, .spacing = 0.005, .rows = 600, .interval = 0.1};
    SpaceTime rows = travelling_surface(grid, {.period = 0.1, .correlation_radius = 0.05, .seed = 5}, 0.3);
    for (std::size_t j = 0; j < rows.rows(); ++j) {
        const double amplitude = rows.at(j, 0);
        for (std::size_t i = 0; i < rows.columns; ++i) rows.row(j)[i] = i % 2 == 0 ? amplitude : -amplitude;
    }
    const SpatialCorrelation correlation = spatial_correlation(rows, 0.1);
    EXPECT_NEAR(correlation.correlation[1], -1.0, 1e-12);
    EXPECT_DOUBLE_EQ(correlation.shortest_period, 0.02);
    const auto fit = fit_surface_correlation(correlation);
    EXPECT_TRUE(std::isnan(fit.characteristic_period.value));
    EXPECT_TRUE(std::isinf(fit.characteristic_period.half_width));
}

TEST(SurfaceCorrelation, TheFittedFunctionHasItsImages) {
    const double period = 0.2;
    // Two images to each side: the first that is left out.
    const double left_out = std::exp(-std::pow(2.0 * period / 0.12, 2));
    for (const double rho : {0.0, 0.03, 0.1}) {
        const double here = horoshenkov_correlation(rho, 0.1, 0.12, period);
        EXPECT_NEAR(here, horoshenkov_correlation(period - rho, 0.1, 0.12, period), left_out);
    }
    EXPECT_DOUBLE_EQ(horoshenkov_correlation(0.0, 0.1, 0.12, period), 1.0);
    EXPECT_EQ(horoshenkov_correlation(0.03, 0.1, 0.12, std::nullopt),
              horoshenkov_correlation(0.03, 0.1, 0.12));
}

TEST(SurfaceCorrelation, OfATravellingSurfaceIsCoveredByItsIntervals) {
    // 150 trials of a 95 % interval scatter by 1.8 %: 89.6-100 % is three standard deviations.
    const SurfaceGrid grid{.columns = 40, .spacing = 0.01, .rows = 600, .interval = 0.1};
    int period = 0, radius = 0, share = 0;
    constexpr int trials = 150;
    double mean_period = 0, mean_radius = 0, width_period = 0, width_radius = 0;
    for (int i = 0; i < trials; ++i) {
        const RandomSurface surface{.period = 0.12,
                                    .correlation_radius = 0.09,
                                    .noise = 5e-4,
                                    .seed = static_cast<std::uint64_t>(i + 1)};
        const auto fit = fit_surface_correlation(
            spatial_correlation(fluctuation(travelling_surface(grid, surface, 0.3)), 0.3));
        period += std::abs(fit.characteristic_period.value - 0.12) <= fit.characteristic_period.half_width;
        radius += std::abs(fit.correlation_radius.value - 0.09) <= fit.correlation_radius.half_width;
        share += std::abs(fit.correlated_share.value - 1.0 / 1.25) <= fit.correlated_share.half_width;
        mean_period += fit.characteristic_period.value / trials;
        mean_radius += fit.correlation_radius.value / trials;
        width_period += fit.characteristic_period.half_width / trials;
        width_radius += fit.correlation_radius.half_width / trials;
    }
    std::printf("L0 covered %.1f %%, sigma_w %.1f %%, share %.1f %%; means %.5f +- %.5f, %.5f +- %.5f\n",
                period / 1.5, radius / 1.5, share / 1.5, mean_period, width_period, mean_radius,
                width_radius);
    EXPECT_GE(period, 135);
    EXPECT_GE(radius, 135);
    EXPECT_GE(share, 135);
    // A fit that is not linear has a bias; it must be small beside the interval of a single trial.
    EXPECT_NEAR(mean_period, 0.12, 0.2 * width_period);
    EXPECT_NEAR(mean_radius, 0.09, 0.2 * width_radius);
}

TEST(SurfaceCorrelation, OfAPeriodicLineKnowsItsImages) {
    // A line of two patterns, whose correlation wraps around. Ever new patterns: waves of random speed.
    const SurfaceGrid grid{.columns = 40, .spacing = 0.005, .periodic = true, .rows = 2, .interval = 1.0};
    SpaceTime all = travelling_surface(grid, {.period = 0.1, .correlation_radius = 0.12, .seed = 1}, 0.0);
    for (std::uint64_t seed = 2; seed < 1500; ++seed) {
        const SpaceTime next =
            travelling_surface(grid, {.period = 0.1, .correlation_radius = 0.12, .seed = seed}, 0.0);
        for (const double t : next.times) all.times.push_back(2.0 * static_cast<double>(seed) + t);
        all.values.insert(all.values.end(), next.values.begin(), next.values.end());
    }
    const SpatialCorrelation c = spatial_correlation(all, 1.0);
    EXPECT_NEAR(c.distance.back(), 0.1, 1e-12);  // half the period
    const auto fit = fit_surface_correlation(c, {.white_noise = false});
    EXPECT_NEAR(fit.characteristic_period.value, 0.1, fit.characteristic_period.half_width + 5e-4);
    EXPECT_NEAR(fit.correlation_radius.value, 0.12, fit.correlation_radius.half_width + 2e-3);
    EXPECT_LT(fit.correlation_radius.half_width, 0.02);
}

TEST(SurfaceCorrelation, OfStationsIsThatOfTheLine) {
    // Probes at uneven places along one line see what the line sees at their distances.
    const SpaceTime line = travelling_surface({.columns = 40, .spacing = 0.01, .rows = 3000, .interval = 0.1},
                                              {.period = 0.12, .correlation_radius = 0.09, .seed = 9}, 0.3);
    std::vector<StationRecord> stations;
    for (const std::size_t column : {0UL, 2UL, 7UL, 17UL}) {
        stations.push_back({line.x(column), line.record(column)});
    }
    const SpatialCorrelation c = spatial_correlation(stations);
    ASSERT_EQ(c.distance.size(), 7U);
    for (std::size_t i = 0; i < c.distance.size(); ++i) {
        // 90 m of surface, one sample in 0.06 m: 0.026; four of them.
        EXPECT_NEAR(c.correlation[i], horoshenkov_correlation(c.distance[i], 0.12, 0.09), 0.1)
            << c.distance[i];
    }
    const auto fit = fit_surface_correlation(c, {.white_noise = false});
    EXPECT_NEAR(fit.characteristic_period.value, 0.12, 2.0 * fit.characteristic_period.half_width);
    EXPECT_LT(fit.characteristic_period.half_width, 0.02);
}

TEST(SurfaceCorrelation, RefusesTooShortRecords) {
    const SpaceTime data = travelling_surface({.columns = 10, .rows = 12}, {}, 0.3);
    EXPECT_THROW((void)spatial_correlation(data, 0.05, 10), InputError);
    EXPECT_THROW((void)spatial_correlation(data, 0.005, 2), InputError);
    EXPECT_NO_THROW((void)spatial_correlation(data, 0.05, 4));
}

}  // namespace
}  // namespace riffle::surface_correlation_test
