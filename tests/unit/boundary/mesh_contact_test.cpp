// What keeps water out of solids in three dimensions.

#include "boundary/mesh_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "boundary/wall.hpp"
#include "particles/lattice.hpp"
#include "periodic_reach.hpp"
#include "stl_box.hpp"
#include "temporary_folder.hpp"

namespace riffle::mesh_contact_test {
namespace {

/// A tank of 60 by 60 by 40 mm, particles 2 mm apart, and a box in it from 20 to 40 mm, up to 20 mm high.
/// With `shift` its sides at x and y lie that far beyond a face of the lattice's cells.
struct TankWithBox {
    Case parameters = test::periodic_reach();
    WallParticles<3> walls;
    MeshContact contact;

    explicit TankWithBox(double shift = 0.0, double foot = -0.01) {
        Case& c = parameters;
        c.channel.ends = Ends::walls;
        c.channel.sides = Sides::walls;
        Solid s;
        s.name = "box";
        s.file = test::folder_of_this_process() / "box.stl";
        test::write_stl_box(s.file, {0.02 - shift, 0.02 - shift, foot}, {0.04 + shift, 0.04 + shift, 0.02});
        c.solids = {s};
        walls = wall_particles<3>(c);
        contact = MeshContact(c, walls);
    }
};

/// The bodies of the tank, none of which moves.
std::vector<BodyState> at_rest() { return std::vector<BodyState>(first_solid + 1); }

TEST(MeshContact, LeavesWaterOutsideAlone) {
    const TankWithBox tank;
    for (const Vec<3> place :
         {Vec<3>{0.0199, 0.03, 0.01}, Vec<3>{0.03, 0.03, 0.0201}, Vec<3>{0.05, 0.01, 0.02}}) {
        Vec<3> x = place;
        Vec<3> u{1.0, 2.0, 3.0};
        EXPECT_EQ(tank.contact.resolve(at_rest(), x, u), 0.0);
        EXPECT_EQ(x, place);
        EXPECT_EQ(u, (Vec<3>{1.0, 2.0, 3.0}));
        EXPECT_EQ(tank.contact.depth(0, at_rest(), place), 0.0);
    }
}

// On the lattice the first layer stands half a spacing behind the face, as that of any wall: none of it is
// the water's.
TEST(MeshContact, PutsWaterBackOntoTheFace) {
    const TankWithBox tank;
    Vec<3> x{0.0206, 0.031, 0.009};
    Vec<3> u{2.0, 0.5, -0.3};
    EXPECT_NEAR(tank.contact.depth(0, at_rest(), x), 0.0006, 1e-9);
    EXPECT_NEAR(tank.contact.resolve(at_rest(), x, u), 0.0006, 1e-9);
    EXPECT_NEAR(x[0], 0.02, 1e-8);
    EXPECT_LE(x[0], 0.02);
    EXPECT_EQ(x[1], 0.031);
    EXPECT_EQ(x[2], 0.009);
    EXPECT_EQ(u[0], 0.0);
    EXPECT_EQ(u[1], 0.5);
    EXPECT_EQ(u[2], -0.3);
    // What leaves already keeps its velocity.
    x = {0.03, 0.03, 0.0195};
    u = {0.1, 0.0, 0.7};
    EXPECT_GT(tank.contact.resolve(at_rest(), x, u), 0.0);
    EXPECT_EQ(u, (Vec<3>{0.1, 0.0, 0.7}));
    EXPECT_GE(x[2], 0.02);
}

// A face 0.6 mm beyond that of the cells: the first layer still stands where the lattice has its places, 1.6
// mm deep, and water comes to rest 1 mm before it.
TEST(MeshContact, LeavesTheWaterItsPlaceBeforeTheFirstLayer) {
    const TankWithBox tank(0.0006);
    Vec<3> x{0.0194 + 0.0005, 0.031, 0.009};
    const Vec<3> before = x;
    Vec<3> u{2.0, 0.0, 0.0};
    EXPECT_EQ(tank.contact.resolve(at_rest(), x, u), 0.0);
    EXPECT_EQ(x, before);
    x[0] = 0.0194 + 0.0009;
    EXPECT_NEAR(tank.contact.resolve(at_rest(), x, u), 0.0003, 1e-9);
    EXPECT_NEAR(x[0], 0.02, 1e-8);
    EXPECT_EQ(u[0], 0.0);
}

TEST(MeshContact, LeavesWhatIsDeeperThanASpacingToTheError) {
    const TankWithBox tank;
    Vec<3> x{0.03, 0.03, 0.0105};
    Vec<3> u{0.0, 0.0, -1.0};
    const Vec<3> before = x;
    EXPECT_EQ(tank.contact.resolve(at_rest(), x, u), 0.0);
    EXPECT_EQ(x, before);
    EXPECT_NEAR(tank.contact.depth(0, at_rest(), x), 0.0095, 1e-9);
}

// The box stands on the bed and moves along y: what it has caught up with goes before its face with it.
TEST(MeshContact, MovesWithTheSolid) {
    TankWithBox tank(0.0, 0.0);
    tank.parameters.solids[0].motion = SolidMotion::constant;
    tank.parameters.solids[0].velocity_y = 0.5;
    tank.contact = MeshContact(tank.parameters, tank.walls);
    const std::vector<BodyState> now = WallMotion(tank.parameters).at(0.01);
    Vec<3> x{0.03, 0.0447, 0.009};
    Vec<3> u{0.2, 0.1, -0.3};
    EXPECT_NEAR(tank.contact.resolve(now, x, u), 0.0003, 1e-9);
    EXPECT_NEAR(x[1], 0.045, 1e-8);
    EXPECT_EQ(u, (Vec<3>{0.2, 0.5, -0.3}));
    // Faster than the face it leaves; and where the box has gone from there is water.
    u = {0.2, 0.7, -0.3};
    x[1] = 0.0447;
    static_cast<void>(tank.contact.resolve(now, x, u));
    EXPECT_EQ(u[1], 0.7);
    x[1] = 0.0203;
    EXPECT_EQ(tank.contact.resolve(now, x, u), 0.0);
}

// Over periodic sides what comes near the lower face of a box that moves is kept off as at the upper one.
TEST(MeshContact, KeepsWaterOffBothFacesOverPeriodicSides) {
    TankWithBox tank(0.0, 0.0);
    tank.parameters.channel.sides = Sides::periodic;
    tank.parameters.solids[0].motion = SolidMotion::constant;
    tank.parameters.solids[0].velocity_y = 0.5;
    tank.walls = wall_particles<3>(tank.parameters);
    tank.contact = MeshContact(tank.parameters, tank.walls);
    const std::vector<BodyState> now = WallMotion(tank.parameters).at(0.01);
    // The box stands from 0.025 to 0.045 m; both points are as far from its faces.
    for (const double away : {-1e-4, 1e-4}) {
        Vec<3> below{0.03, 0.025 - away, 0.009};
        Vec<3> above{0.03, 0.045 + away, 0.009};
        Vec<3> u{0.0, 0.5, 0.0};
        EXPECT_NEAR(tank.contact.resolve(now, below, u), tank.contact.resolve(now, above, u), 1e-9) << away;
        EXPECT_NEAR(below[1] - 0.035, 0.035 - above[1], 1e-8) << away;
    }
}

// The lowest layer has been pressed into the bed: out of the box it comes by the side, not under it.
TEST(MeshContact, HasNoWayOutUnderASolidOnTheBed) {
    const TankWithBox tank(0.0, 0.0);
    Vec<3> x{0.0208, 0.03, -0.0003};
    Vec<3> u{0.1, 0.0, -0.1};
    EXPECT_NEAR(tank.contact.resolve(at_rest(), x, u), 0.0008, 1e-9);
    EXPECT_NEAR(x[0], 0.02, 1e-8);
    EXPECT_EQ(x[2], -0.0003);
    EXPECT_EQ(u[0], 0.0);
}

}  // namespace
}  // namespace riffle::mesh_contact_test
