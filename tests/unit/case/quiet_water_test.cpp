// What follows for the numerics where water shall rest beside inclined faces.

#include "case/quiet_water.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "case/case_documents.hpp"
#include "case_test.hpp"

namespace riffle::quiet_water_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string basin = R"(
[channel]
slope = 0
depth = "100 mm"
length = "1 m"
ends = "walls"

[bed]
kind = "slip"

[turbulence]
closure = "none"

[numerics]
spacing = "5 mm"

[start]
kind = "rest"

[run]
until = "6 s"

[[solid]]
name = "beach"
)";

const std::string beach = "x = [0.5, 1.0, 1.0]\nz = [0.0, 0.2, 0.0]\n";
const std::string step = "x = [0.5, 1.0, 1.0, 0.5]\nz = [0.0, 0.0, 0.05, 0.05]\n";

Case read(const std::string& solid, const std::vector<Override>& overrides = {}) {
    return parse_case(basin + solid, "case.toml", {}, overrides);
}

TEST(QuietWater, BesideABeachHasTheNumericsThatKeepItQuiet) {
    const Case c = read(beach);
    EXPECT_TRUE(is_quiet_beside_inclined_faces(c));
    EXPECT_EQ(c.start.lattice, StartLattice::hexagonal);
    EXPECT_EQ(c.numerics.smoothing_ratio, 1.83);
    EXPECT_EQ(c.numerics.wall_layers, 4);
    EXPECT_EQ(c.numerics.pressure_correction_time, 100.0);
    EXPECT_EQ(read(beach, {{"run.until", "60 s"}}).numerics.pressure_correction_time, 180.0);
}

TEST(QuietWater, KeepsWhatTheCaseGives) {
    const Case c = read(beach, {{"start.lattice", "square"},
                                {"numerics.smoothing_ratio", "2"},
                                {"numerics.pressure_correction_time", "0 s"}});
    EXPECT_EQ(c.start.lattice, StartLattice::square);
    EXPECT_EQ(c.numerics.smoothing_ratio, 2.0);
    EXPECT_EQ(c.numerics.pressure_correction_time, 0.0);
    EXPECT_EQ(read(beach, {{"numerics.preset", "violent"}}).numerics.pressure_correction_time, 0.0);
}

// The smoothing length goes with the lattice: without that one it is as everywhere else.
TEST(QuietWater, OfAnotherLatticeHasTheSmoothingLengthOfThat) {
    const Case c = read(beach, {{"start.lattice", "square"}});
    EXPECT_EQ(c.numerics.smoothing_ratio, 1.5);
    EXPECT_EQ(c.numerics.pressure_correction_time, 100.0);
    EXPECT_THAT(case_warnings(c), Not(Contains(HasSubstr("is not verified"))));
    EXPECT_EQ(read(beach, {{"start.lattice", "hexagonal"}}).numerics.smoothing_ratio, 1.83);
}

TEST(QuietWater, SaysWhatItHas) {
    EXPECT_EQ(
        quiet_water_note(read(beach)).value_or(""),
        "hexagonal lattice, h = 1.83 dx, mean of the pressure's correction over 100 s: the defaults beside "
        "inclined faces");
    EXPECT_THAT(quiet_water_note(read(step)).value_or(""),
                HasSubstr("the defaults where nothing moves the water"));
    EXPECT_FALSE(quiet_water_note(read(step, {{"channel.slope", "0.01"}})));
}

// Two pools of other levels at a wall rest; water that stands in the open, or is connected below the wall,
// does not.
TEST(QuietWater, KnowsWhetherAnythingMovesTheWater) {
    const std::string wall = "x = [0.45, 0.55, 0.55, 0.45]\nz = [0.0, 0.0, 0.2, 0.2]\n";
    const auto with_water = [&](const std::string& solid, const std::string& x, const std::string& z) {
        return is_still(read(solid, {{"start.water_x", x}, {"start.water_z", z}}));
    };
    const std::string behind_each_other = "[0, 1, 1, 0.55, 0.45, 0]";
    EXPECT_TRUE(with_water(wall, behind_each_other, "[0, 0, 0.03, 0.03, 0.09, 0.09]"));
    EXPECT_FALSE(with_water("x = [0.7, 0.75, 0.75, 0.7]\nz = [0, 0, 0.1, 0.1]\n", behind_each_other,
                            "[0, 0, 0.03, 0.03, 0.09, 0.09]"));
    const std::string hanging = "x = [0.45, 0.55, 0.55, 0.45]\nz = [0.02, 0.02, 0.2, 0.2]\n";
    EXPECT_FALSE(with_water(hanging, behind_each_other, "[0, 0, 0.03, 0.03, 0.09, 0.09]"));
    EXPECT_TRUE(with_water(hanging, "[0, 1, 1, 0]", "[0, 0, 0.09, 0.09]"));
    EXPECT_FALSE(with_water(wall, "[0, 0.4, 0.4, 0]", "[0, 0, 0.09, 0.09]"));
    EXPECT_FALSE(with_water(wall, "[0, 0.2, 0.2, 0]", "[0.03, 0.03, 0.09, 0.09]"));
    EXPECT_FALSE(is_still(read(wall + "motion = \"constant\"\nvelocity_x = \"5 mm/s\"\nstop = \"2 s\"\n")));
}

// It is asked before anything is refused: what is no outline, or reaches to the clouds, is for the refusals.
TEST(QuietWater, LeavesWaterThatCannotBeToTheRefusals) {
    const auto refused = [](const std::string& z) {
        try {
            read("x = [0.45, 0.55, 0.55, 0.45]\nz = [0.0, 0.0, 0.2, 0.2]\n",
                 {{"start.water_x", "[0, 1, 1, 0]"}, {"start.water_z", z}});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(refused("[]"), HasSubstr("water_z"));
    EXPECT_THAT(refused("[0, 0, 0.09]"), HasSubstr("water_z"));
    EXPECT_THAT(refused("[0, 0, 1e12, 1e12]"), HasSubstr("water_z"));
}

TEST(QuietWater, KnowsNothingOfWhatStandsAboveIt) {
    EXPECT_FALSE(is_quiet_beside_inclined_faces(read("x = [0.3, 0.7, 0.7]\nz = [0.11, 0.12, 0.3]\n")));
    EXPECT_TRUE(is_quiet_beside_inclined_faces(read("x = [0.3, 0.7, 0.7]\nz = [0.09, 0.12, 0.3]\n")));
}

// A case file that is written of it leaves to it what it chose, so that another preset or length of the run
// counts.
TEST(QuietWater, IsADefaultInTheTemplateOfACase) {
    for (const std::string lattice : {"hexagonal", "square"}) {
        const Case c = read(beach, {{"start.lattice", lattice}});
        const std::string text = case_template(c);
        EXPECT_THAT(text, HasSubstr("\n#pressure_correction_time = "));
        EXPECT_THAT(text, HasSubstr("\n#smoothing_ratio = "));
        EXPECT_THAT(text, HasSubstr(lattice == "hexagonal" ? "\n#lattice = " : "\nlattice = "));
        EXPECT_TRUE(parse_case(text, "template").same_parameters(c));
    }
}

TEST(QuietWater, IsThatOfBasinsWithInclinedFacesAlone) {
    EXPECT_FALSE(is_quiet_beside_inclined_faces(read(step)));
    EXPECT_EQ(read(step, {{"channel.slope", "0.001"}, {"channel.ends", "periodic"}})
                  .numerics.pressure_correction_time,
              0.0);
    const std::string leaving = "motion = \"constant\"\nvelocity_x = \"5 mm/s\"\nstop = \"2 s\"\n";
    const std::string plate = "x = [0.5, 0.6, 0.6]\nz = [0.05, 0.08, 0.02]\n";
    // What is driven steadily needs the pressure corrected at each moment.
    EXPECT_FALSE(is_quiet_beside_inclined_faces(
        read(plate, {{"channel.slope", "0.001"}, {"channel.ends", "periodic"}})));
    EXPECT_FALSE(is_quiet_beside_inclined_faces(read(plate + leaving)));
    const std::string swinging = "motion = \"oscillating\"\namplitude_x = \"5 mm\"\nfrequency = 1\n";
    EXPECT_TRUE(is_quiet_beside_inclined_faces(read(plate + swinging)));
}

/// Reading what a case says of itself gives the case again, with all that was chosen.
TEST(QuietWater, IsKeptInTheTextOfTheCase) {
    const Case c = read(beach);
    EXPECT_TRUE(parse_case(c.text, "text").same_parameters(c));
}

TEST(QuietWater, InSpaceSettlesFirst) {
    const std::string space = R"(
[channel]
dimensions = 3
slope = 0
depth = "60 mm"
length = "60 mm"
width = "200 mm"
sides = "walls"

[bed]
kind = "slip"

[side_walls]
drag_form = "none"

[turbulence]
closure = "none"

[numerics]
spacing = "6 mm"

[start]
kind = "rest"

[run]
until = "6 s"

[[solid]]
name = "sides"
shape = "section"
y = [0.0, 0.1, 0.2]
levels = [0.08, 0.0, 0.08]
)";
    const Case c = parse_case(space, "case.toml");
    EXPECT_TRUE(is_quiet_beside_inclined_faces(c));
    EXPECT_EQ(c.start.lattice, StartLattice::body_centred);
    EXPECT_EQ(c.numerics.smoothing_ratio, 1.65);
    EXPECT_EQ(c.start.settling_time, 2.0);
}

}  // namespace
}  // namespace riffle::quiet_water_test
