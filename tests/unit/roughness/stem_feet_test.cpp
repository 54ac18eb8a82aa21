// Where stems stand: on the bed, or on the top of a solid.

#include "case/stem_feet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/solid_mesh.hpp"
#include "roughness/stem_ground.hpp"
#include "vegetated_channel.hpp"

namespace riffle {
namespace {

Vegetation on(const char* solid) {
    Vegetation stems = test::stems(400.0, 0.006, 0.05, 1.0);
    stems.stands_on = solid;
    return stems;
}

Case beach() {
    Case c = test::slip_channel(0.0, 0.1);
    c.channel.ends = Ends::walls;
    Solid slope;
    slope.name = "beach";
    slope.x = {0.2, 0.5, 0.5};
    slope.z = {0.0, 0.06, 0.0};
    c.solids = {slope};
    return c;
}

TEST(StemFeet, AreOnTheTopOfAnOutlineAndOnTheBedBesideIt) {
    const Case c = beach();
    EXPECT_EQ(stem_foot(c, on(""), 0.35, 0.0), 0.0);
    EXPECT_EQ(stem_foot(c, on("beach"), 0.1, 0.0), 0.0);
    EXPECT_NEAR(stem_foot(c, on("beach"), 0.35, 0.0), 0.03, 1e-12);
    EXPECT_NEAR(stem_foot(c, on("beach"), 0.5, 0.0), 0.06, 1e-12);
    EXPECT_EQ(solid_top(c, c.solids[0], 0.1, 0.0), std::nullopt);
}

TEST(StemFeet, AreOnTheUpperSideOfABridge) {
    Case c = beach();
    c.solids[0].x = {0.1, 0.4, 0.4, 0.1};
    c.solids[0].z = {0.05, 0.05, 0.08, 0.08};
    EXPECT_NEAR(stem_foot(c, on("beach"), 0.2, 0.0), 0.08, 1e-12);
}

TEST(StemFeet, AreOnTheTopOfASurfaceInSpace) {
    Case c = beach();
    c.channel.dimensions = 3;
    c.channel.width = 0.2;
    c.channel.sides = Sides::walls;
    c.solids[0].x = c.solids[0].z = {};
    c.solids[0].shape = SolidShape::sphere;
    c.solids[0].centre = {0.25, 0.1, 0.0};
    c.solids[0].diameter = 0.12;
    c.meshes = meshes_of(c);
    EXPECT_EQ(stem_foot(c, on("beach"), 0.05, 0.1), 0.0);
    // The surface is one of plane triangles between points of the sphere.
    EXPECT_NEAR(stem_foot(c, on("beach"), 0.25, 0.1), 0.06, 1e-3);
    EXPECT_NEAR(stem_foot(c, on("beach"), 0.28, 0.12), std::sqrt(0.06 * 0.06 - 0.03 * 0.03 - 0.02 * 0.02),
                1e-3);
}

TEST(StemFeet, AreLookedUpBetweenPlacesASpacingApart) {
    Case c = beach();
    c.numerics.spacing = 0.01;
    Vegetation stems = on("beach");
    stems.x_from = 0.25;
    stems.x_to = 0.45;
    const StemGround ground(c, stems);
    for (const double x : {0.25, 0.3, 0.333, 0.45}) {
        EXPECT_NEAR(ground.at(x, 0.0), 0.2 * (x - 0.2), 1e-5);
    }
    EXPECT_NEAR(ground.at(0.48, 0.0), 0.05, 1e-5);
    EXPECT_EQ(StemGround(c, on("")).at(0.3, 0.0), 0.0);
}

}  // namespace
}  // namespace riffle
