// What three dimensions demand of a case, and what their words mean.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "case/flow_conditions.hpp"
#include "case_test.hpp"

namespace riffle::space_test {
namespace {

using test::error_of;
using testing::AllOf;
using testing::HasSubstr;

const std::string channel = R"([channel]
slope = 0.004
depth = "50 mm"
length = "50 mm"
width = "43.3 mm"
dimensions = 3

[bed]
roughness_height = "0.4 D"

[numerics]
spacing = "3 mm"
)";

std::string with(const std::string& from, const std::string& to) {
    std::string text = channel;
    text.replace(text.find(from), from.size(), to);
    return text;
}

TEST(Space, ACellOfTheLatticeIsACase) { EXPECT_EQ(error_of(channel), ""); }

TEST(Space, SpheresThatDoNotTileThePeriodAreRefusedWithTheNearestLengths) {
    EXPECT_THAT(error_of(with("\"50 mm\"\nwidth", "\"60 mm\"\nwidth")),
                AllOf(HasSubstr("case.toml:4:"), HasSubstr("length is 60 mm"),
                      HasSubstr("50.0000 mm or 75.0000 mm")));
    EXPECT_THAT(error_of(with("\"43.3 mm\"", "\"60 mm\"")),
                AllOf(HasSubstr("case.toml:5:"), HasSubstr("width is 60 mm"),
                      HasSubstr("sqrt(3) D = 43.3013 mm"), HasSubstr("43.3013 mm or 86.6025 mm")));
    // Between side walls the width is that of the flume, whatever the lattice.
    EXPECT_EQ(error_of(with("\"43.3 mm\"", "\"100 mm\"\nsides = \"walls\"")), "");
}

TEST(Space, SpheresWiderThanTheChannelAreRefused) {
    EXPECT_THAT(error_of(with("\"43.3 mm\"", "\"20 mm\"\nsides = \"walls\"")),
                AllOf(HasSubstr("sphere_diameter is 25 mm, wider than the channel (20 mm)")));
}

TEST(Space, TooFewParticlesOverASphereAreRefused) {
    EXPECT_THAT(error_of(with("\"3 mm\"", "\"7 mm\"")),
                AllOf(HasSubstr("spacing is 7 mm"), HasSubstr("make the spacing 6.25 mm or less")));
}

TEST(Space, WallLayersThickerThanTheEdgeZoneAreRefused) {
    const std::string walls = R"(sides = "walls"

[side_walls]
layer = "20 mm"

[turbulence]
closure = "czernuszenko-rylov")";
    EXPECT_THAT(error_of(with("\"43.3 mm\"\ndimensions = 3", "\"459 mm\"\ndimensions = 3\n" + walls)),
                AllOf(HasSubstr("layer is 20 mm, thicker than the edge zone"), HasSubstr("14.0000 mm")));
}

TEST(Space, WhatDoesNotExistInThreeDimensionsIsRefused) {
    EXPECT_THAT(error_of(with("\"0.4 D\"", "\"0.4 D\"\ndrag_form = \"paper\"")),
                HasSubstr("drag_form = \"paper\" is not there"));
    EXPECT_THAT(error_of(with("dimensions = 3", "dimensions = 4")), HasSubstr("2 or 3"));
}

TEST(Space, WhatExistsInThreeDimensionsAloneIsRefusedInAPlane) {
    const auto plane = [](const std::string& key) { return with("dimensions = 3", key); };
    EXPECT_THAT(error_of(plane("sides = \"walls\"")), HasSubstr("[channel] sides"));
    EXPECT_THAT(error_of(with("dimensions = 3\n\n[bed]", "\n[bed]\ndrag_form = \"slice\"")),
                HasSubstr("goes with [channel] dimensions = 3"));
    EXPECT_THAT(error_of(with("dimensions = 3", "\n[start]\nkind = \"section\"")),
                HasSubstr("[start] kind = \"section\" goes with [channel] dimensions = 3"));
    EXPECT_THAT(error_of(with("dimensions = 3",
                              "\n[[probe]]\nname = \"p\"\nkind = \"wave\"\nsampling_frequency = 10\nx "
                              "= 0.01\ny = 0.01\n")),
                HasSubstr("positions across the channel go with [channel] dimensions = 3"));
}

// The drag of side walls follows from that of the bed's spheres; beside a smooth bed there is none to ask
// for.
TEST(Space, SideWallsOfSmoothBedsHaveNoDragByDefault) {
    const auto tank = [](const std::string& bed, const std::string& more) {
        return parse_case(
            "[channel]\nslope = 0\ndepth = \"100 mm\"\nlength = \"200 mm\"\nwidth = \"100 mm\"\n"
            "dimensions = 3\nends = \"walls\"\nsides = \"walls\"\n[bed]\n" +
                bed +
                "\n[turbulence]\nclosure = \"none\"\n[numerics]\nspacing = \"5 mm\"\n[start]\n"
                "kind = \"rest\"\n[run]\nuntil = \"1 s\"\n" +
                more,
            "tank.toml");
    };
    EXPECT_EQ(tank("kind = \"slip\"", "").side_walls.drag_form, SideDragForm::none);
    EXPECT_EQ(tank("kind = \"no-slip\"", "").side_walls.drag_form, SideDragForm::none);
    EXPECT_EQ(tank("roughness_height = \"10 mm\"", "").side_walls.drag_form, SideDragForm::consistent);
    EXPECT_THROW(static_cast<void>(tank("kind = \"slip\"", "[side_walls]\ndrag_form = \"consistent\"\n")),
                 InputError);
}

TEST(Space, SideWallsOfPlaneBedsHaveTheLogLaw) {
    const auto flume = [](const std::string& more) {
        return parse_case(
            "title = \"flume\"\n[channel]\nslope = 0.001\ndepth = \"100 mm\"\nlength = \"80 mm\"\nwidth = \"400 mm\"\n"
            "dimensions = 3\nsides = \"half\"\n[bed]\nkind = \"roughness\"\nequivalent_roughness = \"5 mm\"\n"
            "[turbulence]\nclosure = \"czernuszenko-rylov\"\n[numerics]\nspacing = \"5 mm\"\n" +
                more,
            "flume.toml");
    };
    EXPECT_EQ(flume("").side_walls.drag_form, SideDragForm::log_law);
    EXPECT_DOUBLE_EQ(flume("").side_layer(), 3 * 0.005);
    const Case glass = flume("[side_walls]\nequivalent_roughness = 0\nlayer = \"12 mm\"\n");
    EXPECT_EQ(glass.side_walls.equivalent_roughness, 0.0);
    EXPECT_DOUBLE_EQ(glass.side_layer(), 0.012);
    EXPECT_EQ(flume("[side_walls]\ndrag_form = \"consistent\"\n").side_walls.drag_form,
              SideDragForm::consistent);
}

TEST(Space, LatticesBelongToTheirDimensions) {
    EXPECT_EQ(error_of(channel + "\n[start]\nlattice = \"body-centred\"\n"), "");
    EXPECT_EQ(error_of(channel + "\n[start]\nlattice = \"hexagonal\"\n"), "");
    EXPECT_THAT(error_of(with("dimensions = 3", "\n[start]\nlattice = \"body-centred\"")),
                HasSubstr("\"body-centred\" is an arrangement in space"));
}

TEST(Space, SnapshotsNameKnownFieldsAndWholeRanges) {
    EXPECT_THAT(error_of(channel + "\n[output]\nsnapshot_fields = \"velocity vorticity\"\n"),
                AllOf(HasSubstr("\"vorticity\" is no field of a snapshot"), HasSubstr("eddy_viscosity")));
    EXPECT_THAT(error_of(channel + "\n[output]\nsnapshot_y = [0.02, 0.01]\n"),
                HasSubstr("snapshot_y: expected two lengths, from and to"));
    EXPECT_EQ(error_of(channel + "\n[output]\nsnapshot_y = [\"10 mm\", \"20 mm\"]\n"), "");
}

TEST(Space, HalfOfAChannelEndsAtItsCentreline) {
    const Case c = builtin_case("condition-2-3d-coarse");
    EXPECT_DOUBLE_EQ(c.channel.simulated_width(), 0.5 * 0.459);
    EXPECT_DOUBLE_EQ(c.channel.centreline(), c.channel.simulated_width());
    EXPECT_TRUE(c.has_side_walls());
    EXPECT_FALSE(builtin_case("condition-2-3d-wide").has_side_walls());
    EXPECT_DOUBLE_EQ(c.turbulence.wake(), 0.2);
}

}  // namespace
}  // namespace riffle::space_test
