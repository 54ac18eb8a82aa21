#include "statistics/quadrants.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "synthetic.hpp"

namespace riffle::quadrants_test {
namespace {

using std::numbers::pi;

/// Density of the product of two Gaussian numbers of unit variance and correlation r.
double product_density(double s, double r) {
    const double c = 1 - r * r;
    return std::exp(r * s / c) * boost::math::cyl_bessel_k(0, std::abs(s) / c) / (pi * std::sqrt(c));
}

/// Integral of power(s, k) times the density over s beyond `threshold` on one side, for |r| < 0.8.
double beyond(double threshold, double r, int side, int power) {
    const auto f = [&](double t) {
        // s = threshold + t^2 takes the logarithm of the density at zero out.
        const double s = threshold + t * t;
        return 2 * t * std::pow(s, power) * product_density(side * s, r);
    };
    const double sum =
        boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, 1e-12, 12.0, 12, 1e-10);
    return power == 1 ? side * sum : sum;
}

std::pair<std::vector<double>, std::vector<double>> velocities(std::size_t n, double r, double phi,
                                                               std::mt19937_64& generator) {
    std::vector<double> u = synthetic::autoregressive(n, phi, generator);
    std::vector<double> w = synthetic::autoregressive(n, phi, generator);
    for (std::size_t i = 0; i < n; ++i) {
        w[i] = 0.5 * (r * u[i] + std::sqrt(1 - r * r) * w[i]);
        u[i] = 3 + 2 * u[i];
    }
    return {u, w};
}

TEST(Quadrants, TheTestsIntegralsAreTheClosedFormsWithoutAHole) {
    for (const double r : {-0.4, 0.0, 0.6}) {
        // Both of like sign: 1/2 + asin(r)/pi, and (sqrt(1 - r^2) + r (pi/2 + asin r))/pi of the product.
        EXPECT_NEAR(beyond(0, r, 1, 0), 0.5 + std::asin(r) / pi, 1e-7);
        EXPECT_NEAR(beyond(0, r, 1, 1), (std::sqrt(1 - r * r) + r * (pi / 2 + std::asin(r))) / pi, 1e-7);
    }
}

// With a few hundred trials, 95 % intervals of eight numbers; the band is three standard deviations, and 2 %
// for the skewness of products in the tail of the distribution.
TEST(Quadrants, IntervalsCoverTheSharesOfGaussianVelocities) {
    constexpr int trials = 200;
    constexpr double r = -0.4;
    for (const double hole : {0.0, 1.5}) {
        std::array<double, 4> time{};
        std::array<double, 4> stress{};
        for (const std::size_t q : {0U, 1U, 2U, 3U}) {
            const int side = q % 2 == 0 ? 1 : -1;
            time[q] = beyond(hole, r, side, 0) / 2;
            stress[q] = beyond(hole, r, side, 1) / 2;
        }
        std::array<int, 4> time_held{};
        std::array<int, 4> stress_held{};
        for (int i = 0; i < trials; ++i) {
            std::mt19937_64 generator(static_cast<std::uint64_t>(i));
            const auto [u, w] = velocities(6000, r, 0.7, generator);
            const Quadrants found = quadrant_analysis(u, w, hole);
            double share = found.time_in_hole.value;
            double sum = 0;
            for (std::size_t q = 0; q < 4; ++q) {
                const Quadrant& quadrant = found.quadrant[q];
                time_held[q] += std::abs(quadrant.time.value - time[q]) <= quadrant.time.half_width ? 1 : 0;
                stress_held[q] +=
                    std::abs(quadrant.stress.value - stress[q]) <= quadrant.stress.half_width ? 1 : 0;
                share += quadrant.time.value;
                sum += quadrant.stress_share;
            }
            EXPECT_NEAR(share, 1, 1e-12);
            if (hole == 0) {
                EXPECT_NEAR(sum, 1, 1e-9);
                EXPECT_NEAR(found.time_in_hole.value, 0, 1e-12);
            }
        }
        const double band = 3 * synthetic::share_deviation(0.95, trials);
        const auto expect = [&](int held) {
            EXPECT_GE(static_cast<double>(held) / trials, 0.95 - band - 0.02);
            EXPECT_LE(static_cast<double>(held) / trials, 0.95 + band);
        };
        std::printf("hole %.1f: covered", hole);
        for (std::size_t q = 0; q < 4; ++q) {
            std::printf(" %.1f/%.1f", 100.0 * time_held[q] / trials, 100.0 * stress_held[q] / trials);
            SCOPED_TRACE("quadrant " + std::to_string(q + 1));
            expect(time_held[q]);
            expect(stress_held[q]);
        }
        std::printf(" %% (time/stress)\n");
    }
}

TEST(Quadrants, AreCountedByHand) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    // Fluctuations about 1 and 0: (1, 1), (-1, 2), (-2, -1), (2, -2), and a sample that only one record has.
    const std::vector<double> u{2, 0, -1, 3, gap};
    const std::vector<double> w{1, 2, -1, -2, 100};
    const Quadrants all = quadrant_analysis(u, w);
    EXPECT_EQ(all.samples, 4U);
    EXPECT_NEAR(all.mean_product.value, (1 - 2 + 2 - 4) / 4.0, 1e-15);
    const std::array<double, 4> products{1, -2, 2, -4};
    for (std::size_t q = 0; q < 4; ++q) {
        EXPECT_NEAR(all.quadrant[q].time.value, 0.25, 1e-15);
        EXPECT_NEAR(all.quadrant[q].stress.value, products[q] / 4, 1e-15);
        EXPECT_NEAR(all.quadrant[q].stress_share, -products[q] / 3, 1e-14);
    }
    // Thresholds: u_rms w_rms = 2.5; |<u'w'>| = 0.75.
    const Quadrants by_deviations = quadrant_analysis(u, w, 1);
    EXPECT_NEAR(by_deviations.threshold, 2.5, 1e-14);
    EXPECT_NEAR(by_deviations.time_in_hole.value, 0.75, 1e-15);
    EXPECT_NEAR(by_deviations.quadrant[3].time.value, 0.25, 1e-15);
    const Quadrants by_mean = quadrant_analysis(u, w, 2, HoleScale::mean_product);
    EXPECT_NEAR(by_mean.threshold, 1.5, 1e-14);
    EXPECT_NEAR(by_mean.time_in_hole.value, 0.25, 1e-15);
}

TEST(Quadrants, RefusesWhatItCannotDo) {
    const std::vector<double> x{1, 2, 3};
    EXPECT_THROW((void)quadrant_analysis(x, x, -1), InputError);
    EXPECT_THROW((void)quadrant_analysis(x, std::vector<double>{1, 2}), InputError);
}

}  // namespace
}  // namespace riffle::quadrants_test
