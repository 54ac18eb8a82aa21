// What a wall particle with a density of its own brings to the pressure sum of its pairs.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "particles/lattice.hpp"
#include "small_case.hpp"

namespace riffle::wall_pressure_test {
namespace {

// In the symmetric form, sum m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W, a particle of a dynamic wall counts as
// water would at its place. Water and wall compressed alike by 4 %: the force of the walls on each particle
// must be the sum over them with p/rho^2 on both sides, to the rounding of the single-precision weights.
TEST(DynamicWall, PushesAsWaterOfItsDensityWould) {
    Case c = test::small_channel();
    c.start.perturbation = 0.0;  // friction at the wall is no part of the sum
    c.numerics.pressure_form = PressureForm::symmetric;
    c.numerics.wall = WallKind::dynamic;
    c.numerics.precision = Precision::double_precision;
    c.numerics.time_step = 1e-12;
    const test::Channel channel(c);
    SimulationIn<2>& simulation = *channel.simulation;
    constexpr double s = 0.04;
    Particles<2> water = simulation.particles();
    std::fill(water.density_deviation.begin(), water.density_deviation.end(), s);
    simulation.restore(water, simulation.clock(), std::vector<double>(simulation.walls().size(), s));
    simulation.step();

    const double h = simulation.scheme().smoothing_length;
    const double length = c.channel.length;
    const double term = simulation.scheme().state.pressure(s) / ((1.0 + s) * (1.0 + s));  // p rho0/rho^2
    const auto& p = simulation.particles();
    const auto& walls = simulation.walls();
    double largest = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        double expected = 0.0;
        for (std::size_t j = 0; j < walls.size(); ++j) {
            double x = p.position[0][i] - walls.position[0][j];
            x -= length * std::round(x / length);
            const double z = p.position[1][i] - walls.position[1][j];
            const double q = std::hypot(x, z) / h;
            const double factor =
                -35.0 / (4.0 * std::numbers::pi) * std::pow(std::max(1.0 - 0.5 * q, 0.0), 3) / std::pow(h, 4);
            expected -= walls.volume[j] * 2.0 * term * factor * z;
        }
        largest = std::max(largest, expected);
        EXPECT_NEAR(simulation.fields().wall_acceleration_z[i], expected, 1e-6 * std::max(expected, 1.0));
    }
    EXPECT_GT(largest, 1.0);
}

// Each wall particle starts with the hydrostatic density of its own height, whatever the walls have been
// sorted by. Else the wall stirs the water before anything has moved.
TEST(DynamicWall, StartsHydrostatic) {
    for (const int dimensions : {2, 3}) {
        Case c = test::small_channel(dimensions);
        c.numerics.wall = WallKind::dynamic;
        const auto expect_hydrostatic = [](const auto& simulation) {
            const auto& walls = simulation.walls();
            const std::size_t vertical = walls.position.size() - 1;
            ASSERT_GT(walls.size(), 0U);
            for (std::size_t i = 0; i < walls.size(); ++i) {
                const double z = walls.position[vertical][i];
                EXPECT_EQ(simulation.wall_density_deviation()[i],
                          simulation.scheme().hydrostatic_deviation(z))
                    << "wall particle " << i << " at z = " << z << " m";
            }
        };
        if (dimensions == 2) {
            expect_hydrostatic(*test::Channel(c).simulation);
        } else {
            expect_hydrostatic(*test::ChannelIn<3>(c).simulation);
        }
    }
}

}  // namespace
}  // namespace riffle::wall_pressure_test
