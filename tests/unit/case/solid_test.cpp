// [[solid]], the outline of the water, the height of end walls and the lid: what is read and what is refused.

#include "case/case_documents.hpp"
#include "case/outline.hpp"
#include "case_test.hpp"

namespace riffle::solid_test {
namespace {

using test::error_of;
using testing::ElementsAre;
using testing::HasSubstr;

/// A tank with a smooth bed; lines go into [channel] and [start].
std::string tank(const std::string& channel, const std::string& start, const std::string& rest = "") {
    return "[channel]\nslope = 0\ndepth = \"50 mm\"\nlength = \"200 mm\"\nends = \"walls\"\n" + channel +
           "[bed]\nkind = \"slip\"\n[turbulence]\nclosure = \"none\"\n[run]\nuntil = \"5 s\"\n[start]\nkind "
           "= \"rest\"\n" +
           start + rest;
}

std::string with_solid(const std::string& x, const std::string& z, const std::string& lines = "",
                       const std::string& start = "") {
    return tank("", start, "[[solid]]\nname = \"weir\"\nx = " + x + "\nz = " + z + "\n" + lines);
}

const char* const step_x = "[0.08, 0.12, 0.12, 0.08]";
const char* const step_z = "[0, 0, 0.02, 0.02]";

TEST(Solids, AreReadAndWritten) {
    const Case c = parse_case(with_solid(R"(["80 mm", "12 cm", 0.1])", "[0, 0, 0.03]",
                                         "motion = \"oscillating\"\nstart = \"1 s\"\namplitude_x = \"5 mm\"\n"
                                         "frequency = \"2 Hz\"\n"),
                              "case.toml");
    ASSERT_EQ(c.solids.size(), 1U);
    EXPECT_EQ(c.solids[0].name, "weir");
    EXPECT_THAT(c.solids[0].x, ElementsAre(0.08, 0.12, 0.1));
    EXPECT_EQ(c.solids[0].motion, SolidMotion::oscillating);
    EXPECT_EQ(c.solids[0].amplitude_x, 0.005);
    EXPECT_TRUE(parse_case(c.text, "text").same_parameters(c));
    EXPECT_TRUE(parse_case(case_template(c), "template").same_parameters(c));
}

// The keys of each depend on one that stands in no [[solid]].
TEST(Solids, SeveralAreReadWithTheDimensionsGiven) {
    const std::string second = "[[solid]]\nname = \"pier\"\nx = [0.15, 0.18, 0.18]\nz = [0, 0, 0.03]\n";
    const Case c = parse_case(with_solid(step_x, step_z) + second, "case.toml");
    ASSERT_EQ(c.solids.size(), 2U);
    EXPECT_NE(c.text.find("dimensions = 2"), std::string::npos);
    EXPECT_TRUE(parse_case(c.text, "text").same_parameters(c));
}

TEST(Solids, OutlinesMustBeSimplePolygons) {
    EXPECT_THAT(error_of(with_solid("[0.08, 0.12]", "[0, 0.02]")), HasSubstr("2 corners"));
    EXPECT_THAT(error_of(with_solid("[0.08, 0.12, 0.1]", "[0, 0.02]")),
                HasSubstr("3 values of x and 2 of z"));
    EXPECT_THAT(error_of(with_solid("[0.08, 0.12, 0.08, 0.12]", "[0, 0, 0.03, 0.03]")),
                HasSubstr("crosses or touches itself"));
    EXPECT_THAT(error_of(with_solid("[0.08, 0.08, 0.12, 0.12]", "[0, 0, 0, 0.03]")),
                HasSubstr("given twice in a row"));
}

TEST(Solids, NeedRoomForTheirLayersAndAPlaceInTheChannel) {
    EXPECT_THAT(error_of(with_solid("[0.08, 0.084, 0.084, 0.08]", "[0, 0, 0.03, 0.03]")),
                HasSubstr("thinner than 4 layers of wall particles (8 mm)"));
    // What tapers off on the bed has no water behind it.
    EXPECT_EQ(error_of(with_solid("[0.06, 0.1, 0.14]", "[0, 0.02, 0]")), "");
    EXPECT_THAT(error_of(with_solid("[0.06, 0.1, 0.14]", "[0.03, 0.034, 0.03]")), HasSubstr("thinner than"));
    // Nor does a plate that lies there until it is lifted; and a wall goes on being thin where it goes
    // through the bed.
    EXPECT_EQ(error_of(with_solid("[0.06, 0.14, 0.14, 0.06]", "[0, 0, 0.002, 0.002]")), "");
    EXPECT_THAT(error_of(with_solid("[0.06, 0.14, 0.14, 0.06]",
                                    "[0, 0, 0.002, 0.002]\nmotion = \"constant\"\nvelocity_z = 0.01")),
                HasSubstr("thinner than"));
    EXPECT_THAT(error_of(with_solid("[0.1, 0.102, 0.102, 0.1]", "[-0.1, -0.1, 0.03, 0.03]")),
                HasSubstr("thinner than"));
    EXPECT_THAT(error_of(with_solid("[0.28, 0.32, 0.32, 0.28]", step_z)),
                HasSubstr("outside of the channel"));
    EXPECT_THAT(error_of(with_solid("[0, 0.2, 0.2, 0]", "[0, 0, 0.2, 0.2]")), HasSubstr("no water is left"));
    EXPECT_EQ(error_of(with_solid(step_x, step_z)), "");
}

TEST(Solids, NeedANameOfTheirOwn) {
    EXPECT_THAT(error_of(with_solid(
                    step_x, step_z,
                    std::string("[[solid]]\nname = \"weir\"\nx = [0.01, 0.03, 0.02]\nz = [0, 0, 0.03]\n"))),
                HasSubstr("another solid has this name"));
}

TEST(Solids, GoWithDummyWallsAndInSpaceNeedAFile) {
    EXPECT_THAT(error_of(with_solid(step_x, step_z, "[numerics]\nwall = \"dynamic\"\n")),
                HasSubstr("goes with [numerics] wall = \"dummy\""));
    EXPECT_THAT(error_of(with_solid(step_x, step_z), {{"channel.dimensions", "3"}}),
                HasSubstr("file is missing"));
}

TEST(Solids, MotionMustBeOneAndHaveRoom) {
    EXPECT_THAT(error_of(with_solid(step_x, step_z, "velocity_x = 1\n")),
                HasSubstr("velocity_x goes only with"));
    EXPECT_THAT(error_of(with_solid(step_x, step_z, "motion = \"constant\"\n")), HasSubstr("at no velocity"));
    EXPECT_THAT(error_of(with_solid(step_x, step_z, "motion = \"oscillating\"\namplitude_x = 0.01\n")),
                HasSubstr("swings by nothing"));
    EXPECT_THAT(
        error_of(with_solid(step_x, step_z, "motion = \"oscillating\"\namplitude_z = 0.01\nfrequency = 1\n")),
        HasSubstr("moves through the bed"));
    EXPECT_THAT(
        error_of(with_solid(step_x, step_z, "motion = \"constant\"\nvelocity_z = 1\nstart = 2\nstop = 1\n")),
        HasSubstr("stops at 1 s, not after its start at 2 s"));
    EXPECT_THAT(error_of(with_solid(step_x, step_z, "motion = \"constant\"\nvelocity_x = 1\n")),
                HasSubstr("moves through the bed or an end wall"));
    EXPECT_EQ(error_of(with_solid(step_x, step_z,
                                  "motion = \"constant\"\nvelocity_x = 0.1\nstart = 1\nstop = 1.5\n")),
              "");
    EXPECT_EQ(error_of(with_solid(step_x, step_z, "motion = \"constant\"\nvelocity_z = 1\n")), "");
}

// The polygon of a circle has its area: its corners stand out of it by a hundredth of the spacing at most.
TEST(Solids, ThatAreRoundMayTurnAndLieOnTheBed) {
    const auto wheel = [](const char* height, const char* motion) {
        return error_of(tank("", "",
                             std::string("[[solid]]\nname = \"wheel\"\nshape = \"circle\"\ndiameter = "
                                         "0.03\ncentre = [0.1, ") +
                                 height + "]\nmotion = \"" + motion));
    };
    EXPECT_EQ(wheel("0.015", "constant\"\nangular_velocity = 1\n"), "");
    EXPECT_EQ(wheel("0.015", "free\"\ndensity = 1500\n"), "");
    EXPECT_THAT(wheel("0.0149", "constant\"\nangular_velocity = 1\n"), HasSubstr("moves through the bed"));
    EXPECT_THAT(wheel("0.0149", "free\"\ndensity = 1500\n"), HasSubstr("starts in the bed or a wall"));
}

TEST(Water, OutlineMustLieInTheChannelAndOutsideOfSolids) {
    const auto water = [](const std::string& x, const std::string& z) {
        return "water_x = " + x + "\nwater_z = " + z + "\n";
    };
    EXPECT_EQ(error_of(tank("", water("[0, 0.05, 0.05, 0]", "[0, 0, 0.05, 0.05]"))), "");
    EXPECT_THAT(error_of(tank("", water("[0, 0.3, 0.3, 0]", "[0, 0, 0.05, 0.05]"))),
                HasSubstr("outside of the channel"));
    EXPECT_THAT(error_of(tank("", water("[0, 0.05, 0.05, 0]", "[0, 0, 0.1, 0.1]"))),
                HasSubstr("give [channel] wall_height"));
    EXPECT_EQ(error_of(tank("wall_height = 0.2\n", water("[0, 0.05, 0.05, 0]", "[0, 0, 0.1, 0.1]"))), "");
    EXPECT_THAT(error_of(tank("", water("[0, 0.05]", "[0, 0]"))), HasSubstr("2 corners"));
    EXPECT_THAT(error_of(with_solid(step_x, step_z, "", water("[0, 0.1, 0.1, 0]", "[0, 0, 0.01, 0.01]"))),
                HasSubstr("lies inside of the solid \"weir\""));
}

TEST(Lid, NeedsAWallWithFrictionAtTheTop) {
    EXPECT_THAT(error_of(tank("lid_velocity = 1\n", "")),
                HasSubstr("lid_velocity goes only with channel.top"));
    EXPECT_THAT(error_of(tank("top = \"wall\"\nlid_velocity = 1\n", "")),
                HasSubstr("set [bed] kind = \"no-slip\""));
    EXPECT_EQ(error_of(tank("top = \"wall\"\nlid_velocity = 1\n", ""), {{"bed.kind", "no-slip"}}), "");
}

TEST(EndWalls, MustHoldTheWater) {
    EXPECT_THAT(error_of(tank("wall_height = \"40 mm\"\n", "")), HasSubstr("lower than the water"));
    std::string open = tank("wall_height = \"90 mm\"\n", "");
    open.replace(open.find("\"walls\""), 7, "\"periodic\"");
    EXPECT_THAT(error_of(open), HasSubstr("wall_height goes only with"));
}

TEST(Outline, KnowsInsideDistanceAndCeiling) {
    const Outline step{{0.0, 2.0, 2.0, 1.0, 1.0, 0.0}, {0.0, 0.0, 1.0, 1.0, 3.0, 3.0}};
    EXPECT_DOUBLE_EQ(signed_area(step), 4.0);
    EXPECT_TRUE(contains(step, 0.5, 2.0));
    EXPECT_FALSE(contains(step, 1.5, 2.0));
    EXPECT_DOUBLE_EQ(distance_from_outline(step, 1.5, 1.5), 0.5);
    EXPECT_DOUBLE_EQ(ceiling_above(step, 0.5, 0.5), 3.0);
    EXPECT_DOUBLE_EQ(ceiling_above(step, 1.5, 0.5), 1.0);
    EXPECT_DOUBLE_EQ(thickness_at(step, 3), 1.0);
    EXPECT_FALSE(crossing_edges(step));
    EXPECT_TRUE(crossing_edges({{0.0, 1.0, 0.0, 1.0}, {0.0, 0.0, 1.0, 1.0}}));
}

}  // namespace
}  // namespace riffle::solid_test
