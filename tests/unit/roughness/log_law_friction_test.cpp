#include "roughness/log_law_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plane_bed.hpp"

namespace riffle::log_law_friction_test {
namespace {

Case flume(double roughness, double viscosity) {
    Case c;
    c.channel.dimensions = 3;
    c.channel.sides = Sides::walls;
    c.side_walls.drag_form = SideDragForm::log_law;
    c.side_walls.layer = 0.012;
    c.side_walls.equivalent_roughness = roughness;
    c.fluid.kinematic_viscosity = viscosity;
    return c;
}

/// Mean over the layer of the log law, over the friction velocity, summed up at many places.
double mean_of_law(double layer, double zero_height) {
    constexpr int places = 200000;
    double sum = 0.0;
    for (int i = 0; i < places; ++i) sum += std::log1p((i + 0.5) / places * layer / zero_height) / 0.41;
    return sum / places;
}

TEST(LogLawFriction, OfARoughWallIsThatOfTheLogLawWithTheMeanOfTheLayer) {
    const double zero_height = 1e-3 * std::exp(-8.5 * 0.41);
    const LogLawFriction friction = side_wall_friction(flume(1e-3, 0.0));
    for (const double speed : {0.01, 0.3, 4.0}) {
        const double friction_velocity = speed / mean_of_law(0.012, zero_height);
        const double stress = friction.coefficient(speed * speed) * 0.012 * speed * speed;
        EXPECT_NEAR(stress, friction_velocity * friction_velocity, 1e-5 * stress);
        EXPECT_EQ(friction.slope(speed * speed), 0.0);
    }
}

TEST(LogLawFriction, OfASmoothWallHasTheZeroHeightOfItsOwnFrictionVelocity) {
    const LogLawFriction friction = side_wall_friction(flume(0.0, 1e-6));
    for (const double speed : {0.1, 0.5, 2.0}) {
        const double square = speed * speed;
        const double friction_velocity = std::sqrt(friction.coefficient(square) * 0.012 * square);
        const double zero_height = 1e-6 / friction_velocity * std::exp(-5.29 * 0.41);
        EXPECT_NEAR(friction_velocity * mean_of_law(0.012, zero_height), speed, 1e-5 * speed);
    }
}

TEST(LogLawFriction, FallsWithTheSpeedWhereViscosityCountsAndKnowsItsSlope) {
    for (const double roughness : {0.0, 2e-4}) {
        const LogLawFriction friction = side_wall_friction(flume(roughness, 1e-6));
        double before = friction.coefficient(0.0);
        EXPECT_TRUE(std::isfinite(before));
        for (const double square : {1e-6, 1e-3, 0.1, 2.0}) {
            const double here = friction.coefficient(square);
            EXPECT_LT(here, before);
            before = here;
            const double step = 0.01 * square;
            const double change = friction.coefficient(square + step) - friction.coefficient(square - step);
            EXPECT_NEAR(friction.slope(square), change / (2.0 * step),
                        1e-3 * std::abs(friction.slope(square)));
        }
        // Water against the stream is held back as well.
        EXPECT_TRUE(std::isfinite(friction.coefficient(-0.1)));
    }
}

TEST(LogLawFriction, WallsAreAsRoughAsABedByRoughness) {
    Case c = flume(0.0, 1e-6);
    c.channel.depth = 0.1;
    test::lay_plane_bed(c, 5e-4);
    const double smooth = side_wall_friction(c).coefficient(0.1);
    c.side_walls.equivalent_roughness.reset();
    const double like_bed = side_wall_friction(c).coefficient(0.1);
    c.side_walls.equivalent_roughness = 5e-4;
    EXPECT_EQ(side_wall_friction(c).coefficient(0.1), like_bed);
    EXPECT_GT(like_bed, 1.2 * smooth);
    // Of a solid the layer is three spacings thick.
    Solid bank;
    bank.equivalent_roughness = 5e-4;
    c.numerics.spacing = 0.004;
    EXPECT_EQ(solid_friction(c, bank).coefficient(0.1), like_bed);
}

}  // namespace
}  // namespace riffle::log_law_friction_test
