// Solids that move into each other.

#include "case/solid_overlap.hpp"

#include "case/triangle.hpp"
#include "case_test.hpp"
#include "stl_box.hpp"
#include "temporary_folder.hpp"

namespace riffle::solid_overlap_test {
namespace {

using test::error_of;
using testing::HasSubstr;

/// A solid of a rectangle that moves with a constant velocity.
Solid block(const std::string& name, double left, double right, double low, double high, double u = 0.0,
            double w = 0.0) {
    Solid s;
    s.name = name;
    s.x = {left, right, right, left};
    s.z = {low, low, high, high};
    s.velocity_x = u;
    s.velocity_z = w;
    s.motion = u != 0.0 || w != 0.0 ? SolidMotion::constant : SolidMotion::fixed;
    return s;
}

Case tank(std::vector<Solid> solids) {
    Case c;
    c.channel.length = 1.0;
    c.channel.depth = 0.2;
    c.channel.ends = Ends::walls;
    c.numerics.spacing = 0.005;
    c.run.until = RunUntil::time;
    c.run.time = 10.0;
    c.solids = std::move(solids);
    return c;
}

TEST(FirstOverlap, FindsWhenTwoSolidsMeet) {
    const auto overlap =
        first_overlap(tank({block("a", 0.2, 0.3, 0.0, 0.1, 0.05), block("b", 0.6, 0.7, 0.05, 0.2, -0.05)}));
    ASSERT_TRUE(overlap);
    // 300 mm apart at 100 mm/s; seen when a tenth of the spacing deep, at the latest one such step later.
    EXPECT_NEAR(overlap->time, 3.0, 0.02);
    EXPECT_GE(overlap->time, 3.0);
    EXPECT_NEAR(overlap->place[0], 0.45, 0.005);
}

TEST(FirstOverlap, LetsThemTouchAndSlide) {
    EXPECT_FALSE(
        first_overlap(tank({block("a", 0.2, 0.3, 0.0, 0.1), block("b", 0.3, 0.4, 0.0, 0.1, 0.0, 0.01)})));
    EXPECT_FALSE(
        first_overlap(tank({block("a", 0.2, 0.3, 0.0, 0.1, 0.05), block("b", 0.6, 0.7, 0.1, 0.2, -0.05)})));
}

TEST(FirstOverlap, KnowsTheStopTheSwingAndTheRestingOnes) {
    Solid stops = block("a", 0.2, 0.3, 0.0, 0.1, 0.05);
    stops.stop = 2.0;
    EXPECT_FALSE(first_overlap(tank({stops, block("b", 0.45, 0.5, 0.0, 0.1)})));
    stops.stop = 4.0;
    EXPECT_TRUE(first_overlap(tank({stops, block("b", 0.45, 0.5, 0.0, 0.1)})));
    Solid swings = block("c", 0.2, 0.3, 0.0, 0.1);
    swings.motion = SolidMotion::oscillating;
    swings.amplitude_x = 0.1;
    swings.frequency = 5.0;
    EXPECT_FALSE(first_overlap(tank({swings, block("b", 0.45, 0.5, 0.0, 0.1)})));
    const auto overlap = first_overlap(tank({swings, block("b", 0.35, 0.5, 0.0, 0.1)}));
    ASSERT_TRUE(overlap);
    EXPECT_NEAR(overlap->time, std::asin(0.5) / (2.0 * 3.14159265 * 5.0), 1e-3);
    // Solids at rest may be put together of several.
    EXPECT_FALSE(first_overlap(tank({block("a", 0.2, 0.3, 0.0, 0.1), block("b", 0.25, 0.4, 0.0, 0.1)})));
}

TEST(FirstOverlap, SeesACrossWithoutCornersInside) {
    EXPECT_TRUE(first_overlap(
        tank({block("upright", 0.4, 0.45, 0.0, 0.2, 0.001), block("flat", 0.3, 0.6, 0.08, 0.12)})));
}

TEST(FirstOverlap, GoesOnThroughPeriodicEnds) {
    Case c = tank({block("a", 0.05, 0.1, 0.0, 0.1, -0.05), block("b", 0.8, 0.9, 0.0, 0.1)});
    EXPECT_FALSE(first_overlap(c));
    c.channel.ends = Ends::periodic;
    const auto overlap = first_overlap(c);
    ASSERT_TRUE(overlap);
    EXPECT_NEAR(overlap->time, 0.15 / 0.05, 0.02);
}

TEST(Solids, ThatMoveThroughEachOtherAreRefused) {
    const std::string text =
        "[channel]\nslope = 0\ndepth = \"50 mm\"\nlength = \"200 mm\"\nends = \"walls\"\n"
        "[bed]\nkind = \"slip\"\n[turbulence]\nclosure = \"none\"\n[run]\nuntil = \"5 s\"\n[start]\nkind = "
        "\"rest\"\n"
        "[[solid]]\nname = \"pier\"\nx = [0.15, 0.18, 0.18, 0.15]\nz = [0, 0, 0.03, 0.03]\n"
        "[[solid]]\nname = \"piston\"\nx = [0.0, 0.03, 0.03, 0.0]\nz = [0, 0, 0.07, 0.07]\n"
        "motion = \"constant\"\nvelocity_x = \"50 mm/s\"\nstop = ";
    EXPECT_EQ(error_of(text + "\"2 s\"\n"), "");
    const std::string error = error_of(text + "\"3 s\"\n");
    EXPECT_THAT(error, HasSubstr("piston"));
    EXPECT_THAT(error, HasSubstr("meets the solid \"pier\" at t = 2.4"));
    EXPECT_THAT(error, HasSubstr("let it stop before"));
}

/// A box in space that moves with a constant velocity.
Solid box(const std::string& name, const Point3& low, const Point3& high, const Point3& velocity = {}) {
    Solid s;
    s.name = name;
    s.file = test::folder_of_this_process() / (name + ".stl");
    test::write_stl_box(s.file, low, high);
    s.velocity_x = velocity[0];
    s.velocity_y = velocity[1];
    s.velocity_z = velocity[2];
    s.motion = velocity != Point3{} ? SolidMotion::constant : SolidMotion::fixed;
    return s;
}

Case basin(std::vector<Solid> solids) {
    Case c = tank(std::move(solids));
    c.channel.dimensions = 3;
    c.channel.width = 0.5;
    c.channel.sides = Sides::walls;
    return c;
}

TEST(FirstOverlap, FindsWhenTwoBoxesMeet) {
    const Solid first = box("a", {0.2, 0.1, 0.0}, {0.3, 0.2, 0.1}, {0.0, 0.02, 0.0});
    const auto overlap = first_overlap(basin({first, box("b", {0.25, 0.3, 0.05}, {0.4, 0.4, 0.2})}));
    ASSERT_TRUE(overlap);
    EXPECT_NEAR(overlap->time, 5.0, 0.05);
    EXPECT_GE(overlap->time, 5.0);
    EXPECT_NEAR(overlap->place[1], 0.3, 0.005);
    // One passes beside the other, and along it.
    EXPECT_FALSE(first_overlap(basin({first, box("c", {0.31, 0.3, 0.0}, {0.4, 0.4, 0.2})})));
    EXPECT_FALSE(first_overlap(basin({first, box("d", {0.3, 0.3, 0.0}, {0.4, 0.4, 0.2})})));
}

TEST(FirstOverlap, SeesBoxesAcrossEachOtherAndInEachOther) {
    const auto plus =
        first_overlap(basin({box("upright", {0.4, 0.2, 0.0}, {0.45, 0.25, 0.2}, {0.0, 0.0, 0.001}),
                             box("flat", {0.3, 0.1, 0.08}, {0.6, 0.4, 0.12})}));
    ASSERT_TRUE(plus);
    EXPECT_EQ(plus->time, 0.0);
    EXPECT_TRUE(first_overlap(basin({box("inner", {0.4, 0.2, 0.05}, {0.45, 0.25, 0.1}, {0.0, 0.0, 0.001}),
                                     box("outer", {0.3, 0.1, 0.0}, {0.6, 0.4, 0.2})})));
}

TEST(FirstOverlap, GoesOnThroughPeriodicSides) {
    Case c = basin({box("south", {0.2, 0.1, 0.0}, {0.3, 0.2, 0.1}, {0.0, -0.05, 0.0}),
                    box("north", {0.2, 0.3, 0.0}, {0.3, 0.4, 0.1})});
    EXPECT_FALSE(first_overlap(c));
    c.channel.sides = Sides::periodic;
    const auto overlap = first_overlap(c);
    ASSERT_TRUE(overlap);
    EXPECT_NEAR(overlap->time, 0.2 / 0.05, 0.05);
}

}  // namespace
}  // namespace riffle::solid_overlap_test
