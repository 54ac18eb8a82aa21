#include "boundary/repulsive_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "smooth_tank.hpp"

namespace riffle::repulsive_wall_test {
namespace {

constexpr double sound_speed = 10.0;

Case tank() {
    Case c = test::smooth_tank(0.05, 0.1);
    c.numerics.wall = WallKind::repulsive;
    return c;
}

/// The force of a row of particles along x at z = 0, one after another, on water at rest at the depth of the
/// bed.
double force_of_row(const Case& c, double x, double z) {
    const double dx = c.numerics.spacing;
    const double h = c.numerics.smoothing_ratio * dx;
    const double q = z / (2.0 * dx);
    double sum = 0.0;
    for (int i = -20; i <= 70; ++i) {
        const double along = std::abs(x - (i + 0.5) * dx);
        if (q < 1.0 && along < dx) {
            sum += c.fluid.gravity * c.total_depth() / h * (1.0 - q) / std::sqrt(q) * 0.5 *
                   (1.0 + std::cos(std::numbers::pi * along / dx));
        }
    }
    return sum;
}

// The plane is what the row of particles acts like at every place.
TEST(RepulsiveWalls, ActAsTheirParticles) {
    const Case c = tank();
    const RepulsiveWalls<2> walls(c, sound_speed);
    for (const double x : {0.05, 0.0503, 0.0511, 0.0518}) {
        for (const double share : {0.1, 0.5, 0.9}) {
            const double z = share * 2.0 * c.numerics.spacing;
            const double depth_factor = std::min(1.0, (0.05 - z) / 0.05 + 0.02);
            EXPECT_NEAR(walls.acceleration({x, z}, {})[1], depth_factor * force_of_row(c, x, z), 1e-9);
        }
        EXPECT_EQ(walls.acceleration({x, 2.0 * c.numerics.spacing}, {}), (Vec<2>{})) << "beyond the reach";
    }
}

// In space the end walls of a tank push as its side walls do.
TEST(RepulsiveWalls, PushInwardsFromAllWallsInSpace) {
    Case c = tank();
    c.channel.dimensions = 3;
    c.channel.width = 0.08;
    c.channel.sides = Sides::walls;
    const RepulsiveWalls<3> walls(c, sound_speed);
    const double strength = walls.acceleration({0.001, 0.04, 0.025}, {})[0];
    EXPECT_GT(strength, 0.0);
    EXPECT_NEAR(walls.acceleration({0.1 - 0.001, 0.04, 0.025}, {})[0], -strength, 1e-9 * strength);
    EXPECT_NEAR(walls.acceleration({0.05, 0.001, 0.025}, {})[1], strength, 1e-9 * strength);
    EXPECT_NEAR(walls.acceleration({0.05, 0.08 - 0.001, 0.025}, {})[1], -strength, 1e-9 * strength);
    EXPECT_EQ(walls.acceleration({0.05, 0.04, 0.025}, {}), (Vec<3>{}));
}

TEST(RepulsiveWalls, PushInwardsFromAllWalls) {
    const RepulsiveWalls<2> walls(tank(), sound_speed);
    const Vec<2> left = walls.acceleration({0.001, 0.025}, {});
    const Vec<2> right = walls.acceleration({0.1 - 0.001, 0.025}, {});
    EXPECT_GT(left[0], 0.0);
    EXPECT_NEAR(right[0], -left[0], 1e-9 * left[0]);
    EXPECT_EQ(left[1], 0.0);
    const Vec<2> corner = walls.acceleration({0.001, 0.001}, {});
    EXPECT_GT(corner[0], 0.0);
    EXPECT_GT(corner[1], 0.0);
    EXPECT_GT(walls.acceleration({0.05, -0.001}, {})[1], walls.acceleration({0.05, 0.001}, {})[1])
        << "what has passed the wall is pushed back";
}

// End walls push as the pressure grows, and everything harder that comes nearer.
TEST(RepulsiveWalls, PushByDepthAndApproach) {
    const RepulsiveWalls<2> walls(tank(), sound_speed);
    const double middle = walls.acceleration({0.001, 0.025}, {})[0];
    EXPECT_NEAR(walls.acceleration({0.001, 0.05}, {})[0] / middle, 0.02 / 0.52, 1e-12);
    EXPECT_EQ(walls.acceleration({0.001, 0.025}, {0.1, 0.3})[0], middle) << "receding, and along the wall";
    EXPECT_NEAR(walls.acceleration({0.001, 0.025}, {-0.1, 0.0})[0] / middle, 0.72 / 0.52, 1e-12);
    EXPECT_NEAR(walls.acceleration({0.001, 0.025}, {-5.0, 0.0})[0] / middle, 1.52 / 0.52, 1e-12);
}

TEST(RepulsiveWalls, AreThereOnRequestAlone) {
    Case c = tank();
    EXPECT_TRUE(RepulsiveWalls<2>(c, sound_speed).active());
    c.numerics.wall = WallKind::dummy;
    EXPECT_FALSE(RepulsiveWalls<2>(c, sound_speed).active());
    EXPECT_FALSE(RepulsiveWalls<2>().active());
}

TEST(RepulsiveWalls, InSpaceSideWallsPushToo) {
    Case c = tank();
    c.channel.dimensions = 3;
    c.channel.ends = Ends::periodic;
    c.channel.width = 0.04;
    c.channel.sides = Sides::walls;
    const RepulsiveWalls<3> walls(c, sound_speed);
    EXPECT_GT(walls.acceleration({0.05, 0.001, 0.025}, {})[1], 0.0);
    EXPECT_LT(walls.acceleration({0.05, 0.039, 0.025}, {})[1], 0.0);
    EXPECT_EQ(walls.acceleration({0.001, 0.02, 0.025}, {}), (Vec<3>{}));
}

}  // namespace
}  // namespace riffle::repulsive_wall_test
