#include "analysis/upwelling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "synthetic_surface.hpp"

namespace riffle::upwelling_test {
namespace {

using std::numbers::pi;

/// cos(k x + phase) at each time, `waves` of them on the line.
SpaceTime waves_on_line(int waves, bool periodic, double noise) {
    SpaceTime data = travelling_surface({.columns = 120, .spacing = 0.01, .periodic = periodic, .rows = 200},
                                        {.deviation = 0.0, .noise = noise}, 0.0);
    for (std::size_t j = 0; j < data.rows(); ++j) {
        for (std::size_t i = 0; i < data.columns; ++i) {
            data.row(j)[i] +=
                0.01 * std::cos(2 * pi * waves * data.x(i) / data.length() + 0.1 * static_cast<double>(j));
        }
    }
    return data;
}

TEST(Upwelling, CountsTheCellsAroundAPeriodicLine) {
    const UpwellingCounts c = count_upwellings(waves_on_line(5, true, 0.0), 0.1);
    EXPECT_DOUBLE_EQ(c.upwellings.mean, 5.0);
    EXPECT_DOUBLE_EQ(c.downwellings.mean, 5.0);
    // 1.2 m are 12 depths.
    EXPECT_NEAR(c.upwellings_per_depth, 5.0 / 12.0, 1e-12);
}

TEST(Upwelling, NoiseAroundZeroAddsNone) {
    // Noise of 10 % of the amplitude about the zeros stays below half of the deviation (0.35 of the
    // amplitude).
    const UpwellingCounts c = count_upwellings(waves_on_line(5, true, 1e-3), 0.1);
    EXPECT_DOUBLE_EQ(c.upwellings.mean, 5.0);
    EXPECT_GT(count_upwellings(waves_on_line(5, true, 1e-3), 0.1, 0.0).upwellings.mean, 5.0);
}

TEST(Upwelling, AnOpenLineHoldsTheCellsAtItsEnds) {
    const UpwellingCounts c = count_upwellings(waves_on_line(3, false, 0.0), 0.1);
    EXPECT_GE(c.upwellings.mean, 3.0);
    EXPECT_LE(c.upwellings.mean, 4.0);
}

TEST(Upwelling, SurfaceVelocityIsTheKinematicCondition) {
    // eta = a cos(k x - omega t): w = a (omega - u k) sin(k x - omega t), to (k dx)^2/6 and (omega dt)^2/6.
    const double k = 2 * pi / 0.4, omega = 3.0, u = 0.2, a = 1e-3;
    SpaceTime eta =
        travelling_surface({.columns = 80, .spacing = 0.005, .periodic = true, .rows = 50, .interval = 0.01},
                           {.deviation = 0.0}, 0.0);
    for (std::size_t j = 0; j < eta.rows(); ++j) {
        for (std::size_t i = 0; i < eta.columns; ++i) {
            eta.row(j)[i] = a * std::cos(k * eta.x(i) - omega * eta.times[j]);
        }
    }
    const SpaceTime w = surface_vertical_velocity(eta, u);
    const double bound = a * (omega * std::pow(omega * 0.01, 2) + u * k * std::pow(k * 0.005, 2)) / 6;
    for (std::size_t j = 1; j + 1 < w.rows(); ++j) {
        for (std::size_t i = 0; i < w.columns; ++i) {
            EXPECT_NEAR(w.at(j, i), a * (omega - u * k) * std::sin(k * w.x(i) - omega * w.times[j]), bound);
        }
    }
    eta.row(3)[10] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(surface_vertical_velocity(eta, u).at(3, 11)));
}

TEST(Upwelling, ExpectedNumberIsHalfTheAspectRatio) {
    EXPECT_DOUBLE_EQ(expected_upwellings(0.46, 0.046), 5.0);
    EXPECT_THROW((void)count_upwellings(waves_on_line(3, true, 0.0), 0.0), InputError);
}

}  // namespace
}  // namespace riffle::upwelling_test
