// The statistics of a cell of the mean field against sums in double precision.

#include "solver/cell_sums.hpp"

#include <gtest/gtest.h>

#include <random>

namespace riffle::cell_sums_test {
namespace {

// Fluctuations of a twentieth of the mean: their squares are 1/400 of those of the velocities, and what
// single precision makes of each sample (6e-8) may show in them as 400 times as much.
TEST(CellSums, KeepSmallFluctuationsOfManySamples) {
    CellSums cells({1, 1, 2});
    const CellPlace cell{0, 0, 1};
    std::mt19937 generator(5);
    std::normal_distribution<double> noise(0.0, 0.02);
    constexpr int samples = 20000;
    double u = 0.0;
    double w = 0.0;
    double uu = 0.0;
    double uw = 0.0;
    double pressure = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double first = noise(generator);
        const CellSample sample{
            .velocity = {0.4 + first, noise(generator), 0.5 * noise(generator) - 0.4 * first},
            .pressure = 500.0 + 100.0 * noise(generator)};
        cells.add(cell, sample);
        u += sample.velocity[0] / samples;
        w += sample.velocity[2] / samples;
        uu += sample.velocity[0] * sample.velocity[0] / samples;
        uw += sample.velocity[0] * sample.velocity[2] / samples;
        pressure += sample.pressure / samples;
    }
    using Q = CellQuantity;
    EXPECT_EQ(cells.get(cell, Q::count), samples);
    EXPECT_NEAR(cells.get(cell, Q::u), u, 1e-6);
    EXPECT_NEAR(cells.get(cell, Q::pressure), pressure, 1e-3);
    EXPECT_NEAR(cells.get(cell, Q::uu) / (uu - u * u), 1.0, 1e-4);
    EXPECT_NEAR(cells.get(cell, Q::uw) / (uw - u * w), 1.0, 1e-4);
    EXPECT_EQ(cells.get({0, 0, 0}, Q::count), 0.0);
    cells.clear();
    EXPECT_EQ(cells.get(cell, Q::uu), 0.0);
}

}  // namespace
}  // namespace riffle::cell_sums_test
