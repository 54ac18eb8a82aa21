#include "column/twin_reaches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"

namespace riffle {
namespace {

using ::testing::HasSubstr;

Case over_beds(const std::string& patch) {
    return parse_case(
        "[channel]\nslope = 0.003\ndepth = \"60 mm\"\nlength = \"1.5 m\"\nends = \"open\"\n"
        "[inflow]\nunit_discharge = \"0.03 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"60 mm\"\n"
        "[bed]\nkind = \"roughness\"\nequivalent_roughness = \"1 mm\"\n[[bed_patch]]\nname = \"middle\"\n" +
            patch + "x_from = \"0.5 m\"\nx_to = \"0.9 m\"\n" +
            "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = \"6 mm\"\n[start]\nkind = \"uniform\"\n"
            "[run]\nuntil = \"8 s\"\n",
        "test");
}

// The bed of the channel before and behind a patch that covers its width, and to the end of a longer one.
TEST(TwinReaches, AreTheBedsOneBehindTheOther) {
    const Case c = over_beds("equivalent_roughness = \"12 mm\"\n");
    const auto reaches = twin_reaches(c, 0.03, 4.0);
    ASSERT_EQ(reaches.size(), 3U);
    EXPECT_EQ(reaches[0].name, "");
    EXPECT_EQ(reaches[1].name, "middle");
    EXPECT_DOUBLE_EQ(reaches[1].from, 0.5);
    EXPECT_DOUBLE_EQ(reaches[1].to, 0.9);
    EXPECT_DOUBLE_EQ(reaches[2].to, 4.0);
    EXPECT_GT(reaches[1].channel.state(0.06).friction_slope,
              1.5 * reaches[2].channel.state(0.06).friction_slope);
}

// Each bed is known by its friction; which one has none is said.
TEST(TwinReaches, NeedFrictionOverEachBed) {
    try {
        static_cast<void>(twin_reaches(over_beds("kind = \"slip\"\n"), 0.03, 1.5));
        FAIL() << "a slip bed has no varied flow";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("nothing resists the flow over [[bed_patch]] middle"));
    }
}

/// A strip of gravel along one side of a flume, from 0.5 to 0.9 m.
Case over_strip() {
    Case c = over_beds("equivalent_roughness = \"12 mm\"\n");
    c.channel.dimensions = 3;
    c.channel.width = 0.6;
    c.channel.sides = Sides::half;
    c.side_walls.drag_form = SideDragForm::none;
    c.bed_patches.front().y_to = 0.1;
    return c;
}

// Beside other beds the friction is that of the cross-section: a strip over a third of the width lies between
// the bed of the channel and the strip everywhere.
TEST(TwinReaches, HaveTheFrictionOfStripsBetweenSideWalls) {
    const Case c = over_strip();
    const auto reaches = twin_reaches(c, 0.03, 1.5);
    ASSERT_EQ(reaches.size(), 3U);
    EXPECT_EQ(reaches[1].name, "middle");
    EXPECT_DOUBLE_EQ(reaches[1].from, 0.5);
    Case everywhere = c;
    everywhere.bed_patches.front().y_to.reset();
    const double of_strip = reaches[1].channel.state(0.06).friction_slope;
    EXPECT_GT(of_strip, 1.1 * reaches[0].channel.state(0.06).friction_slope);
    EXPECT_LT(of_strip, 0.9 * twin_reaches(everywhere, 0.03, 1.5)[1].channel.state(0.06).friction_slope);
}

// Edges of two strips that begin at one place make one reach.
TEST(TwinReaches, ChangeWhereABedDoes) {
    Case c = over_strip();
    c.bed_patches.push_back(c.bed_patches.front());
    c.bed_patches.back().name = "sand";
    c.bed_patches.back().equivalent_roughness = 0.0005;
    c.bed_patches.back().y_from = 0.2;
    c.bed_patches.back().y_to = 0.3;
    c.bed_patches.back().x_to = 1.5;
    const auto reaches = twin_reaches(c, 0.03, 1.5);
    ASSERT_EQ(reaches.size(), 3U);
    EXPECT_EQ(reaches[1].name, "middle and sand");
    EXPECT_EQ(reaches[2].name, "sand");
    EXPECT_DOUBLE_EQ(reaches[2].from, 0.9);
}

// What lies beside another bed at one place without a twin would be left out of the friction.
TEST(TwinReaches, AreNotOfStripsInAnEndlesslyWideChannel) {
    Case c = over_strip();
    c.channel.sides = Sides::periodic;
    try {
        static_cast<void>(twin_reaches(c, 0.03, 1.5));
        FAIL() << "a patch beside another bed has no varied flow";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("[[bed_patch]] middle lies in a part of the width"));
    }
}

}  // namespace
}  // namespace riffle
