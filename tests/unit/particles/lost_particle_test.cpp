// The ledger of particles that left: on which way, and how much water they were.

#include "particles/lost_particle.hpp"

#include <gtest/gtest.h>

namespace riffle::lost_particle_test {
namespace {

/// A tank of 1 m with 0.3 m of water and end walls of 0.5 m.
Case tank() {
    Case c;
    c.channel.depth = 0.3;
    c.channel.length = 1.0;
    c.channel.ends = Ends::walls;
    c.channel.wall_height = 0.5;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.numerics.spacing = 0.01;
    return c;
}

/// Position and velocity in the plane after so many seconds of free flight.
struct Flight {
    std::array<double, 3> position;
    std::array<double, 3> velocity;
};
Flight after(double time, double x, double z, double u, double w) {
    return {{x + u * time, 0.0, z + w * time - 0.5 * 9.81 * time * time}, {u, 0.0, w - 9.81 * time}};
}

TEST(ExitOf, TellsAFlightOverAnEndWallFromALeakThroughIt) {
    // Past x = 1 at 0.6 m and at 0.2 m, both long below the bed when they are taken out.
    const Flight over = after(0.4, 1.0, 0.6, 1.5, 0.3);
    const Flight through = after(0.4, 1.0, 0.2, 1.5, 0.3);
    EXPECT_LT(over.position[2], 0.0);
    EXPECT_EQ(exit_of(tank(), over.position, over.velocity), Exit::over_end);
    EXPECT_EQ(exit_of(tank(), through.position, through.velocity), Exit::through_end);
    const Flight back = after(0.3, 0.0, 0.55, -1.0, 0.0);
    EXPECT_EQ(exit_of(tank(), back.position, back.velocity), Exit::over_start);
    // What comes back from outside is no flight over the wall.
    EXPECT_EQ(exit_of(tank(), {-0.2, 0.0, 0.6}, {0.5, 0.0, 0.0}), Exit::through_start);
}

TEST(ExitOf, WithoutEndWallsIsTheTopOrTheBed) {
    Case c = tank();
    c.channel.ends = Ends::periodic;
    EXPECT_EQ(exit_of(c, {0.5, 0.0, -0.2}, {1.0, 0.0, -1.0}), Exit::through_bed);
    EXPECT_EQ(exit_of(c, {0.5, 0.0, 2.0}, {1.0, 0.0, 3.0}), Exit::above);
}

TEST(ExitOf, InThreeDimensionsKnowsTheSideWalls) {
    Case c = tank();
    c.channel.dimensions = 3;
    c.channel.width = 0.4;
    EXPECT_EQ(exit_of(c, {0.5, -0.1, 0.6}, {0.0, -1.0, 0.0}), Exit::over_side);
    EXPECT_EQ(exit_of(c, {0.5, 0.5, 0.1}, {0.0, 1.0, 0.0}), Exit::through_side);
}

TEST(LostWater, IsTheShareOfAllThatThereWas) {
    const std::vector<LostParticle> lost = {{.id = 3, .mass = 0.1, .exit = Exit::over_end},
                                            {.id = 9, .mass = 0.1, .exit = Exit::over_end},
                                            {.id = 1, .mass = 0.1, .exit = Exit::through_bed}};
    const LostWater water = lost_water(lost, 299.7);
    EXPECT_EQ(water.particles, 3U);
    EXPECT_DOUBLE_EQ(water.mass, 0.1 + 0.1 + 0.1);
    EXPECT_NEAR(water.share, 1e-3, 1e-15);
    EXPECT_EQ(lost_text(water), "3 particles (0.1 % of the water)");
    EXPECT_EQ(exits_text(lost), "2 over the far end wall, 1 through the bed");
    EXPECT_EQ(exits_text({}), "");
    EXPECT_EQ(lost_water({}, 0.0).share, 0.0);
}

}  // namespace
}  // namespace riffle::lost_particle_test
