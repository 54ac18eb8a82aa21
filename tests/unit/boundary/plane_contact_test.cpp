// Planes that keep single particles from passing a wall.

#include "boundary/plane_contact.hpp"

#include <gtest/gtest.h>

namespace riffle::plane_contact_test {
namespace {

/// A closed tank of 60 by 60 by 40 mm, particles 2 mm apart; its walls stand 50 mm high.
template <int D>
Case tank() {
    Case c;
    c.channel.dimensions = D;
    c.channel.ends = Ends::walls;
    c.channel.sides = D == 3 ? Sides::walls : Sides::periodic;
    c.channel.wall_height = 0.05;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.channel.depth = 0.04;
    c.channel.length = 0.06;
    c.channel.width = D == 3 ? 0.06 : 0.0;
    c.numerics.spacing = 0.002;
    return c;
}

TEST(PlaneContact, PutsWaterBackAndLeavesTheRestOfItsVelocity) {
    const PlaneContact<2> planes(tank<2>());
    Vec<2> x{-0.001, 0.01};
    Vec<2> u{-2.0, 0.5};
    EXPECT_DOUBLE_EQ(planes.resolve(x, u), 0.001);
    EXPECT_EQ(x, (Vec<2>{0.0, 0.01}));
    EXPECT_EQ(u, (Vec<2>{0.0, 0.5}));
}

TEST(PlaneContact, LetsWaterThatLeavesTheWallGo) {
    const PlaneContact<2> planes(tank<2>());
    Vec<2> x{0.03, -0.0006};
    Vec<2> u{0.1, 3.0};
    EXPECT_DOUBLE_EQ(planes.resolve(x, u), 0.0006);
    EXPECT_EQ(u, (Vec<2>{0.1, 3.0}));
}

TEST(PlaneContact, HoldsInACorner) {
    const PlaneContact<3> planes(tank<3>());
    Vec<3> x{0.0606, -0.001, -0.0015};
    Vec<3> u{1.0, -1.0, -1.0};
    EXPECT_DOUBLE_EQ(planes.resolve(x, u), 0.0015);
    EXPECT_EQ(x, (Vec<3>{0.06, 0.0, 0.0}));
    EXPECT_EQ(u, (Vec<3>{}));
}

TEST(PlaneContact, TouchesNothingThatIsNotInAWall) {
    const PlaneContact<2> planes(tank<2>());
    for (const Vec<2>& place : {Vec<2>{0.0, 0.0}, Vec<2>{0.03, 0.02}, Vec<2>{0.03, -0.0004},
                                Vec<2>{0.03, -0.0021}, Vec<2>{-0.001, 0.055}, Vec<2>{-0.01, 0.02}}) {
        Vec<2> x = place;
        Vec<2> u{-1.0, -1.0};
        EXPECT_EQ(planes.resolve(x, u), 0.0);
        EXPECT_EQ(x, place);
        EXPECT_EQ(u, (Vec<2>{-1.0, -1.0}));
    }
}

TEST(PlaneContact, HasNoEndsWhereTheChannelGoesOn) {
    Case c = tank<2>();
    c.channel.ends = Ends::periodic;
    const PlaneContact<2> planes(c);
    Vec<2> x{-0.001, 0.01};
    Vec<2> u{-2.0, 0.0};
    EXPECT_EQ(planes.resolve(x, u), 0.0);
}

}  // namespace
}  // namespace riffle::plane_contact_test
