#include "ends/end_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "column/column.hpp"
#include "ends/end_extremes.hpp"
#include "ends/narrowest_opening.hpp"
#include "ends/section_state.hpp"
#include "particles/lattice.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

const std::string channel = R"(
[channel]
slope = 0.004
depth = "50 mm"
length = "600 mm"
ends = "open"
[bed]
kind = "spheres"
roughness_height = "0.4 D"
[run]
until = "10 s"
)";

Case open_case(const std::string& ends) { return parse_case(channel + ends, "test"); }

/// A channel whose discharge is still to come from a file.
Case free_channel_of_a_file() {
    Case c = open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\nkind = \"free\"\n");
    c.inflow.unit_discharge.reset();
    return c;
}

std::string message_of(const Case& c) {
    try {
        (void)read_end_input(c);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

class EndFiles : public ::testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& text) {
        std::filesystem::path path = folder_.path() / name;
        std::ofstream(path) << text;
        return path;
    }
    test::TemporaryFolder folder_;
};

TEST(EndInput, TheTwinsProfileHasTheDischarge) {
    const EndInput input = read_end_input(open_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n"));
    EXPECT_NEAR(input.entering->mean_of_streams(0.0, 1000, std::vector{0.0}), 1.0, 1e-4);
    // The velocities of the uniform flow of the same bed over its mean.
    const Case uniform = parse_case(
        "[channel]\nslope = 0.004\ndepth = \"50 mm\"\n[bed]\nkind = \"spheres\"\nroughness_height = \"0.4 D\"\n",
        "test");
    const ColumnResult twin = solve_column(uniform);
    for (const double place : {0.05, 0.2, 0.5, 0.95}) {
        EXPECT_NEAR(input.entering->mean_at(0.0, place) * twin.total_mean_velocity /
                        twin.velocity_at(place * uniform.total_depth()),
                    1.0, 2e-3)
            << place;
    }
}

// Between side walls the water that enters is that of the section twin: slower beside them; with the column's
// profile it is the same all across.
TEST(EndInput, BetweenSideWallsTheSectionEnters) {
    const auto read = [](const std::string& profile) {
        return read_end_input(parse_case(
            "[channel]\nslope = 0.004\ndepth = \"50 mm\"\nlength = \"300 mm\"\nends = \"open\"\ndimensions = 3\n"
            "sides = \"walls\"\nwidth = \"200 mm\"\n[bed]\nkind = \"spheres\"\nroughness_height = \"0.4 D\"\n"
            "[side_walls]\ndrag_form = \"consistent\"\n[turbulence]\nclosure = \"czernuszenko-rylov\"\n"
            "[numerics]\nspacing = \"3 mm\"\n[run]\nuntil = \"10 s\"\n[inflow]\nunit_discharge = \"0.015 m2/s\"\n" +
                profile,
            "test"));
    };
    const EndInput twin = read("");
    std::vector<double> files;
    files.reserve(200);
    for (int file = 0; file < 200; ++file) files.push_back(0.001 * (file + 0.5));
    EXPECT_NEAR(twin.entering->mean_of_streams(0.0, 200, files), 1.0, 2e-3);
    EXPECT_LT(twin.entering->mean_at(0.003, 0.6), 0.9 * twin.entering->mean_at(0.1, 0.6));
    EXPECT_NEAR(twin.entering->mean_at(0.02, 0.6), twin.entering->mean_at(0.18, 0.6), 1e-9);
    EXPECT_GE(twin.entering->largest(), twin.entering->mean_at(0.1, 0.9));
    const EndInput column = read("profile = \"column\"\n");
    EXPECT_EQ(column.entering->mean_at(0.003, 0.6), column.entering->mean_at(0.1, 0.6));
    // The normal depth of the outflow knows of the walls too.
    EXPECT_NEAR(twin.outflow_depth(0.0, 0.0), column.outflow_depth(0.0, 0.0), 1e-9);
    EXPECT_GT(twin.outflow_depth(0.0, 0.0), 0.056);
}

TEST(EndInput, TheNormalDepthIsThatOfTheUniformFlow) {
    const Case c = open_case("[inflow]\ndischarge = \"7.992 l/s\"\n");
    EXPECT_NEAR(*c.inflow_unit_discharge(), 0.007992 / 0.459, 1e-12);
    // riffle backwater: the normal depth of this discharge is that of the case, 50 mm over the datum.
    EXPECT_NEAR(read_end_input(c).outflow_depth(0.0, 0.0), c.total_depth(), 1e-5);
}

TEST(EndInput, EachKindOfOutflowHasItsDepth) {
    const auto depth = [](const std::string& outflow, double q) {
        return read_end_input(open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\n" + outflow))
            .outflow_depth(q, 3.0);
    };
    const double g = open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n").normal_gravity();
    EXPECT_NEAR(depth("kind = \"depth\"\ndepth = \"80 mm\"\n", 0.02), 0.086, 1e-12);
    EXPECT_NEAR(depth("kind = \"critical-depth\"\n", 0.02), std::cbrt(0.0004 / g), 1e-12);
    // The head over the crest: q = (2/3) C_d sqrt(2 g) head^1.5.
    const double head =
        depth("kind = \"weir\"\nweir_height = \"40 mm\"\nweir_coefficient = 0.6\n", 0.02) - 0.046;
    EXPECT_NEAR(2.0 / 3.0 * 0.6 * std::sqrt(2.0 * g) * std::pow(head, 1.5), 0.02, 1e-12);
    EXPECT_FALSE(
        read_end_input(open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\nkind = \"free\"\n"))
            .outflow_depth);
}

// Depths that a case gives are levels over the datum; over a solid at the end the water is as much shallower.
TEST(EndInput, OverASolidTheWaterIsShallowerByItsHeight) {
    const std::string solid =
        "[[solid]]\nname = \"sill\"\nx = [-0.2, 0.8, 0.8, -0.2]\nz = [0, 0, 0.01, 0.01]\n";
    const auto read = [&](const std::string& more, const std::string& solids) {
        return read_end_input(
            open_case("[inflow]\nunit_discharge = \"0.05 m2/s\"\ndepth = \"40 mm\"\nprofile = "
                      "\"uniform\"\n[outflow]\n" +
                      more + solids));
    };
    for (const std::string kind :
         {"kind = \"depth\"\ndepth = \"90 mm\"\n", "kind = \"weir\"\nweir_height = \"40 mm\"\n"}) {
        const EndInput bed = read(kind, "");
        const EndInput over_solid = read(kind, solid);
        EXPECT_NEAR(over_solid.inflow_depth->at(0.0), bed.inflow_depth->at(0.0) - 0.01, 1e-12);
        EXPECT_NEAR(over_solid.outflow_depth(0.05, 0.0), bed.outflow_depth(0.05, 0.0) - 0.01, 1e-12);
    }
    // The critical depth is one over what the water stands on.
    const std::string critical = "kind = \"critical-depth\"\n";
    EXPECT_EQ(read(critical, solid).outflow_depth(0.05, 0.0), read(critical, "").outflow_depth(0.05, 0.0));
}

TEST(EndInput, TheEndsOfADuctKeepTheRelaxationTimesOfTheCase) {
    const auto read = [](const std::string& inflow, const std::string& outflow) {
        return read_end_input(
            parse_case("[channel]\nslope = 0\ndepth = 0.02\nlength = 0.3\nends = \"open\"\ntop = "
                       "\"wall\"\n[bed]\nkind = \"no-slip\"\n[turbulence]\nclosure = \"none\"\n"
                       "[start]\nkind = \"uniform\"\n[numerics]\nspacing = 0.001\n[run]\nuntil = 1\n"
                       "[inflow]\nunit_discharge = 1e-3\nprofile = \"uniform\"\n" +
                           inflow + "[outflow]\nkind = \"pressure\"\n" + outflow,
                       "duct"));
    };
    const EndInput own = read("", "");
    EXPECT_TRUE(own.duct);
    EXPECT_NEAR(own.relaxation_time, 0.1 * 0.3 / 0.05, 1e-12);
    EXPECT_NEAR(own.inflow_relaxation_time, 0.1 * 0.3 / 0.05, 1e-12);
    const EndInput given = read("relaxation_time = 2\n", "relaxation_time = 3\n");
    EXPECT_EQ(given.inflow_relaxation_time, 2.0);
    EXPECT_EQ(given.relaxation_time, 3.0);
}

// The jet behind a sill must not draw the water apart, and its sound speed is that of the jet; what leaves
// most of the duct open, as a cylinder does, changes nothing.
TEST(EndInput, ADuctWithAConstrictionHasThePressureForItsJet) {
    const auto duct = [](double sill) {
        Case c = parse_case(
            "[channel]\nslope = 0\ndepth = \"200 mm\"\nlength = \"2 m\"\nends = \"open\"\ntop = \"wall\"\n"
            "[inflow]\nunit_discharge = 0.1\nprofile = \"uniform\"\n[outflow]\nkind = \"pressure\"\n"
            "[bed]\nkind = \"slip\"\n[turbulence]\nclosure = \"none\"\n[numerics]\nspacing = \"10 mm\"\n"
            "[start]\nkind = \"uniform\"\n[run]\nuntil = \"1 s\"\n",
            "test");
        if (sill > 0.0) {
            Solid solid;
            solid.name = "sill";
            solid.x = {0.6, 0.8, 0.8, 0.6};
            solid.z = {0.0, 0.0, sill, sill};
            c.solids = {solid};
        }
        return c;
    };
    EXPECT_DOUBLE_EQ(narrowest_opening(duct(0.0)), 1.0);
    EXPECT_DOUBLE_EQ(narrowest_opening(duct(0.1)), 0.5);
    EXPECT_DOUBLE_EQ(read_end_input(duct(0.0)).outflow_pressure, 0.25);
    EXPECT_DOUBLE_EQ(read_end_input(duct(0.04)).outflow_pressure, 0.25);
    const double jet = 0.5 / (0.61 * 0.5);
    EXPECT_NEAR(read_end_input(duct(0.1)).outflow_pressure, jet * jet, 1e-9);
    EXPECT_NEAR(end_extremes(duct(0.1), read_end_input(duct(0.1))).velocity, jet, 1e-9);
}

// A depth that changes by a file is followed, but for waves that are short for that change.
TEST_F(EndFiles, ADepthThatChangesIsFollowed) {
    Case c =
        open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = 0.06\n");
    const double held = read_end_input(c).relaxation_time;
    c.outflow.depth.reset();
    const auto follows = [&](const std::string& rows) {
        c.outflow.depth_file = write("tide.csv", "time [s],depth [mm]\n" + rows);
        return read_end_input(c).relaxation_time;
    };
    EXPECT_NEAR(follows("0,60\n50,80\n100,60\n150,70\n"), 0.25, 1e-12);  // 20 mm at 0.4 mm/s
    EXPECT_EQ(read_end_input(c).inflow_relaxation_time, read_end_input(c).relaxation_time);
    EXPECT_EQ(follows("0,60\n100000,80\n"), held);
    EXPECT_NEAR(read_end_input(c).inflow_relaxation_time, 5.0 / 80.0 * held, 1e-12);
    EXPECT_EQ(follows("0,60\n10,60\n"), held);
    EXPECT_NEAR(follows("0,60\n1,60\n1.01,70\n") / held, 1.0 / 80.0, 1e-12);
}

TEST_F(EndFiles, AHydrographIsReadInItsUnits) {
    Case c = free_channel_of_a_file();
    c.inflow.discharge_file = write("flood.csv", "time [s],discharge [l/s]\n0,4.59\n10,9.18\n");
    const EndInput input = read_end_input(c);
    EXPECT_NEAR(input.unit_discharge->at(0.0), 0.01, 1e-12);
    EXPECT_NEAR(input.unit_discharge->at(5.0), 0.015, 1e-12);
    EXPECT_NEAR(input.unit_discharge->at(50.0), 0.02, 1e-12);
}

TEST_F(EndFiles, WrongFilesAreToldWithTheirPlace) {
    Case c = free_channel_of_a_file();
    c.inflow.discharge_file = write("late.csv", "time,unit_discharge\n2,0.01\n3,0.01\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("begins at 2 s"));
    c.inflow.discharge_file = write("back.csv", "time,unit_discharge\n0,0.01\n3,0.01\n3,0.02\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("back.csv:4"));
    c.inflow.discharge_file = write("names.csv", "time,flow\n0,0.01\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("no column discharge or unit_discharge"));
    c.inflow.discharge_file = write("both.csv", "time,discharge,unit_discharge\n0,0.01,0.02\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("columns discharge and unit_discharge; leave one"));
    c.inflow.discharge_file = write("below.csv", "time,unit_discharge\n0,0.01\n3,-0.01\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("below.csv:3"));
    c.inflow.discharge_file = write("hole.csv", "time,unit_discharge\n0,0.01\n3,\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("hole.csv:3"));
    Case other = open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\nkind = \"free\"\n");
    other.inflow.profile = InflowProfile::file;
    other.inflow.profile_file = write("profile.csv", "z,u\n0.01,0.1\n0.02,\n0.03,0.3\n");
    EXPECT_THAT(message_of(other), ::testing::HasSubstr("profile.csv:3"));
}

// A flood, or a level, over the top of the domain would leave it.
TEST_F(EndFiles, WhatRisesOverTheDomainIsRefused) {
    Case c = free_channel_of_a_file();
    // Critical depths of 0.2 and 0.25 m in a channel that has room for four times 56 mm.
    c.inflow.discharge_file = write("flood.csv", "time,unit_discharge\n0,0.02\n9,0.28\n");
    EXPECT_EQ(message_of(c), "");
    EXPECT_GT(domain_of<2>(c).upper[1], 0.25);
    c.inflow.discharge_file = write("high.csv", "time,unit_discharge\n0,0.02\n9,0.39\n");
    EXPECT_THAT(message_of(c), ::testing::AllOf(::testing::HasSubstr("high.csv: critical flow"),
                                                ::testing::HasSubstr("[channel] depth at least")));
    c = open_case(
        "[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"60 mm\"\n");
    c.outflow.depth.reset();
    c.outflow.depth_file = write("levels.csv", "time [s],depth [mm]\n0,60\n9,300\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("levels.csv: its largest depth is 300 mm"));
    // Nor can an outflow hold less than the critical depth of the discharge, 34 mm, 6 of them below the
    // datum.
    c.outflow.depth_file = write("shallow.csv", "time [s],depth [mm]\n0,60\n9,20\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("shallow.csv: it holds 20 mm"));
    c.outflow.depth_file = write("right.csv", "time [s],depth [mm]\n0,60\n9,40\n");
    EXPECT_EQ(message_of(c), "");
}

// What a rule holds must have room as well as what a table says.
TEST_F(EndFiles, WhatARuleHoldsMustHaveRoom) {
    Case c = open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\nkind = \"free\"\n");
    c.outflow.kind = OutflowKind::rating_curve;
    // Millimetres without their unit: 60 m.
    c.outflow.rating_file = write("metres.csv", "depth,unit_discharge\n20,0\n60,0.02\n");
    EXPECT_THAT(message_of(c),
                ::testing::AllOf(::testing::HasSubstr("metres.csv: [outflow] kind = \"rating-curve\""),
                                 ::testing::HasSubstr("has room for")));
    // The normal depth of a flood in a flat channel, whose critical depth of 0.13 m has room.
    c = free_channel_of_a_file();
    c.outflow.kind = OutflowKind::normal_depth;
    c.inflow.discharge_file = write("flood.csv", "time,unit_discharge\n0,0.02\n9,0.15\n");
    EXPECT_EQ(message_of(c), "");
    c.channel.slope = 0.0004;
    EXPECT_THAT(message_of(c),
                ::testing::AllOf(::testing::HasSubstr("flood.csv: [outflow] kind = \"normal-depth\""),
                                 ::testing::HasSubstr("has room for")));
}

// Of subcritical water depth or discharge comes from downstream, at each moment.
TEST_F(EndFiles, DepthAndDischargeOfASlowInflowAreRefused) {
    Case c = free_channel_of_a_file();
    // Critical depths of 34 and 55 mm.
    c.inflow.discharge_file = write("flood.csv", "time,unit_discharge\n0,0.02\n9,0.04\n");
    c.inflow.depth = 0.04;
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("flood.csv: at t = 0 s the depth of 40 mm is above"));
    c.inflow.depth = 0.028;
    EXPECT_EQ(message_of(c), "");
    c.inflow.depth.reset();
    c.inflow.depth_file = write("depths.csv", "time [s],depth [mm]\n0,28\n9,28\n");
    EXPECT_EQ(message_of(c), "");
    c.inflow.depth_file = write("rises.csv", "time [s],depth [mm]\n0,20\n3,60\n6,20\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("rises.csv: at t = "));
}

// The speed of sound is that of the highest water that a table brings; what was before the run is forgotten.
TEST_F(EndFiles, AllRowsFromTheStartOnSetTheNumerics) {
    Case c =
        open_case("[inflow]\nunit_discharge = \"0.002 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = 0.05\n");
    EXPECT_NEAR(end_extremes(c, read_end_input(c)).depth, c.total_depth(), 1e-12);
    const double held = read_end_input(c).relaxation_time;
    c.outflow.depth.reset();
    c.outflow.depth_file = write("rise.csv", "time [s],depth [mm]\n0,50\n20,150\n");
    EXPECT_NEAR(end_extremes(c, read_end_input(c)).depth, 0.15 + c.datum(), 1e-12);
    // A fall and a rise before the run.
    c.outflow.depth_file =
        write("before.csv", "time [s],depth [mm]\n-9,150\n-8,30\n-7.9,60\n-2,50\n-1,50\n10,50\n");
    EXPECT_NEAR(end_extremes(c, read_end_input(c)).depth, c.total_depth(), 1e-12);
    EXPECT_EQ(read_end_input(c).relaxation_time, held);
    c.outflow.depth_file = write("across.csv", "time [s],depth [mm]\n-10,40\n10,60\n");
    const TimeTable across = *read_end_input(c).outflow_table;
    EXPECT_NEAR(across.at(0.0) - c.datum(), 0.05, 1e-12);
    EXPECT_NEAR(across.at(5.0) - c.datum(), 0.055, 1e-12);
    EXPECT_EQ(across.times().front(), 0.0);
}

// A level that the case itself names raises the domain.
TEST(EndLevels, TheDomainReachesOverWhatTheEndsHold) {
    const auto top = [](const std::string& outflow) {
        const Case c = open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\n" + outflow);
        return domain_of<2>(c).upper[1];
    };
    const double usual = top("kind = \"depth\"\ndepth = \"50 mm\"\n");
    EXPECT_EQ(top("kind = \"depth\"\ndepth = \"45 mm\"\n"), usual);
    EXPECT_NEAR(top("kind = \"depth\"\ndepth = \"200 mm\"\n") - usual, 0.3, 1e-12);
    EXPECT_GT(top("kind = \"weir\"\nweir_height = \"120 mm\"\n") - usual, 0.2);
}

TEST_F(EndFiles, ARatingCurveGivesTheDepth) {
    Case c = open_case("[inflow]\nunit_discharge = \"0.02 m2/s\"\n[outflow]\nkind = \"free\"\n");
    c.outflow.kind = OutflowKind::rating_curve;
    c.outflow.rating_file = write("rating.csv", "depth [mm],unit_discharge [m2/s]\n20,0\n60,0.02\n");
    EXPECT_NEAR(read_end_input(c).outflow_depth(0.01, 0.0), 0.046, 1e-12);
    // Beyond its ends it says nothing.
    c.outflow.rating_file = write("short.csv", "depth [mm],unit_discharge [m2/s]\n20,0\n60,0.019\n");
    EXPECT_THAT(message_of(c),
                ::testing::HasSubstr("ends at 19 l/s per metre of width, and the largest discharge "
                                     "that enters is 20 l/s"));
    // Rows that come after the end of the run count for nothing.
    Case flood = c;
    flood.inflow.unit_discharge.reset();
    flood.inflow.discharge_file = write("flood.csv", "time,unit_discharge\n0,0.01\n20,0.019\n600,0.08\n");
    flood.run.time = 15.0;
    EXPECT_EQ(message_of(flood), "");
    flood.run.time = 30.0;
    EXPECT_THAT(message_of(flood), ::testing::HasSubstr("largest discharge that enters is 20"));
    c.outflow.rating_file = write("late.csv", "depth [mm],unit_discharge [m2/s]\n60,0.021\n90,0.04\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("begins at 21 l/s"));
    c.outflow.rating_file = write("falls.csv", "depth [mm],unit_discharge [m2/s]\n20,0.02\n60,0.01\n");
    EXPECT_THAT(message_of(c), ::testing::HasSubstr("does not rise"));
}

// Varied flow at the start: deep where the outflow is dammed, near the normal depth far from it.
TEST(EndInput, ABackwaterStartsOnItsCurve) {
    const Case c = open_case(
        "[inflow]\nunit_discharge = \"0.017411 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"60 mm\"\n"
        "[start]\nkind = \"backwater\"\n");
    const auto depth = start_depths(c, read_end_input(c));
    EXPECT_NEAR(depth(0.6), 0.066, 1e-9);
    // The surface is nearly level: the bed falls by 2.4 mm, the depth by nearly as much less.
    EXPECT_LT(depth(0.0), 0.0653);
    EXPECT_GT(depth(0.0), 0.0636);
}

}  // namespace
}  // namespace riffle
