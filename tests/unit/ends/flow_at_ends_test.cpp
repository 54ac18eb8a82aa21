#include "ends/flow_at_ends.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "base/error.hpp"
#include "ends/end_extremes.hpp"
#include "ends/end_input.hpp"
#include "ends/relaxation_between_ends.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Case slip_case(const std::string& more) {
    return parse_case(
        "[channel]\nslope = 0\ndepth = \"180 mm\"\nlength = \"1.4 m\"\nends = \"open\"\n[bed]\nkind = \"slip\"\n"
        "[turbulence]\nclosure = \"none\"\n[start]\nkind = \"uniform\"\n[run]\nuntil = \"6 s\"\n" +
            more,
        "test");
}

Case rough_case(const std::string& more) {
    return parse_case(
        "[channel]\nslope = 0.004\ndepth = \"50 mm\"\nlength = \"600 mm\"\nends = \"open\"\n[bed]\n"
        "kind = \"spheres\"\nroughness_height = \"0.4 D\"\n[run]\nuntil = \"10 s\"\n" +
            more,
        "test");
}

std::string text_of(const Case& c) {
    std::string text;
    for (const EndFact& fact : end_facts(c, flow_at_ends(c))) text += fact.label + ": " + fact.text + "\n";
    return text;
}

// Without friction: U = q/H, Fr = U/sqrt(g H), the critical depth (q^2/g)^(1/3).
TEST(FlowAtEnds, WithoutFrictionItIsThatOfTheDischarge) {
    const Case c = slip_case(
        "[inflow]\nunit_discharge = \"0.03 m2/s\"\nprofile = \"uniform\"\n[outflow]\nkind = \"depth\"\n"
        "depth = \"100 mm\"\n");
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_NEAR(flow.outflow.velocity->least, 0.3, 1e-12);
    EXPECT_NEAR(flow.outflow.froude->least, 0.3 / std::sqrt(9.81 * 0.1), 1e-12);
    EXPECT_NEAR(flow.outflow.critical_depth->least, std::cbrt(0.0009 / 9.81), 1e-12);
    EXPECT_FALSE(flow.outflow.normal_depth);
    EXPECT_EQ(flow.inflow.source, DepthSource::start);
    EXPECT_NEAR(flow.inflow.depth->least, 0.18, 1e-12);
    EXPECT_THAT(text_of(c), HasSubstr("holds 100 mm, U = 0.3 m/s, Fr = 0.3029, subcritical"));
}

// Between side walls strips of plane beds have the twin of a cross-section: those of the same bed change
// nothing, rougher ones make the uniform flow deeper, by less than such a bed all over.
TEST(FlowAtEnds, StripsBetweenSideWallsHaveANormalDepth) {
    const auto normal_depth = [](const std::string& bed, const std::string& strip) {
        const Case c = parse_case(
            "[channel]\ndimensions = 3\nslope = 0.002\ndepth = \"60 mm\"\nlength = \"300 mm\"\nwidth = \"240 mm\"\n"
            "sides = \"half\"\nends = \"open\"\n[inflow]\nunit_discharge = \"0.024 m2/s\"\n[outflow]\n"
            "kind = \"normal-depth\"\n[side_walls]\nequivalent_roughness = 0\n[turbulence]\nclosure = "
            "\"nezu-rodi\"\n[numerics]\nspacing = \"5 mm\"\n[run]\nuntil = \"1 s\"\n[bed]\nkind = \"roughness\"\n"
            "equivalent_roughness = \"" +
                bed + "\"\n" +
                (strip.empty()
                     ? ""
                     : "[[bed_patch]]\nname = \"strip\"\ny_from = \"60 mm\"\nequivalent_roughness = \"" +
                           strip + "\"\n"),
            "test");
        return flow_at_ends(c).outflow.normal_depth.value().least;
    };
    const double smooth = normal_depth("1 mm", "");
    EXPECT_NEAR(normal_depth("1 mm", "1 mm") / smooth, 1.0, 2e-3);
    const double partly = normal_depth("1 mm", "10 mm");
    EXPECT_GT(partly, 1.02 * smooth);
    EXPECT_LT(partly, normal_depth("10 mm", ""));
}

// A patch beside another bed, without a mirror image, has no twin: what needs none is told all the same.
TEST(FlowAtEnds, APatchBesideAnotherBedWithoutATwinHasNoNormalDepth) {
    const Case c = parse_case(
        "[channel]\ndimensions = 3\nslope = 0.002\ndepth = \"60 mm\"\nlength = \"300 mm\"\nwidth = \"240 mm\"\n"
        "sides = \"walls\"\nends = \"open\"\n[inflow]\nunit_discharge = \"0.024 m2/s\"\nprofile = \"uniform\"\n"
        "[outflow]\nkind = \"depth\"\ndepth = \"60 mm\"\n[side_walls]\nequivalent_roughness = 0\n[turbulence]\n"
        "closure = \"nezu-rodi\"\n[numerics]\nspacing = \"5 mm\"\n[start]\nkind = \"uniform\"\n[run]\nuntil = \"1 s\"\n"
        "[bed]\nkind = \"roughness\"\nequivalent_roughness = \"1 mm\"\n[[bed_patch]]\nname = \"strip\"\n"
        "y_to = \"60 mm\"\nequivalent_roughness = \"10 mm\"\n",
        "test");
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_FALSE(flow.inflow.normal_depth);
    EXPECT_NEAR(flow.outflow.velocity->least, 0.4, 1e-12);
}

double largest_velocity(const Case& c) { return end_extremes(c, read_end_input(c)).velocity; }

// Where the depth of the inflow is not given, water shoots off on a steep slope, to uniform flow.
TEST(FlowAtEnds, TheSpeedOnASteepSlopeIsThatOfUniformFlow) {
    const auto at_slope = [](const std::string& slope, const std::string& more) {
        return parse_case(
            "[channel]\nslope = " + slope +
                "\ndepth = \"40 mm\"\nlength = \"1.5 m\"\nends = \"open\"\n[bed]\nkind = \"roughness\"\n"
                "equivalent_roughness = \"1 mm\"\n[numerics]\nspacing = \"2.5 mm\"\n[run]\nuntil = \"5 s\"\n"
                "[outflow]\nkind = \"free\"\n[inflow]\nunit_discharge = \"0.03 m2/s\"\n" +
                more,
            "test");
    };
    const Case steep = at_slope("0.03", "");
    const double uniform = 0.03 / flow_at_ends(steep).inflow.normal_depth->least;
    // The profile's largest velocity is some fifth above its mean.
    EXPECT_GT(largest_velocity(steep), 1.1 * uniform);
    EXPECT_NEAR(largest_velocity(steep), largest_velocity(at_slope("0.03", "depth = \"24.77 mm\"\n")),
                0.01 * uniform);
    EXPECT_LT(largest_velocity(at_slope("0.001", "")), uniform);
}

// Nothing holds it on a slip bed: U^2 grows by 2 g S0 L.
TEST(FlowAtEnds, TheSpeedWithoutFrictionIsThatOfFreeFall) {
    const std::string free_outflow =
        "[inflow]\nunit_discharge = \"0.03 m2/s\"\nprofile = \"uniform\"\n[outflow]\nkind = \"free\"\n";
    Case c = slip_case(free_outflow);
    EXPECT_NEAR(largest_velocity(c), 0.03 / 0.18, 1e-12);
    c.channel.slope = 0.05;
    const double critical = std::cbrt(c.normal_gravity() * 0.03);
    EXPECT_NEAR(largest_velocity(c), std::sqrt(critical * critical + 2.0 * c.streamwise_gravity() * 1.4),
                1e-9);
}

// A hydrograph: the range of the run, not of rows behind its end; no faster than critical flow.
TEST(FlowAtEnds, TablesGiveTheRangeDuringTheRun) {
    test::TemporaryFolder folder;
    std::ofstream(folder.path() / "flood.csv") << "time,unit_discharge\n0,0.05\n2,0.2\n5,0.05\n9,0.01\n";
    Case c = slip_case(
        "[inflow]\nunit_discharge = \"0.05 m2/s\"\nprofile = \"uniform\"\n[outflow]\nkind = \"critical-depth\"\n");
    c.inflow.unit_discharge.reset();
    c.inflow.discharge_file = folder.path() / "flood.csv";
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_NEAR(flow.unit_discharge.least, 0.04, 1e-12);  // at 6 s
    EXPECT_NEAR(flow.unit_discharge.largest, 0.2, 1e-12);
    EXPECT_NEAR(flow.inflow.velocity->least, 0.04 / 0.18, 1e-12);
    EXPECT_NEAR(flow.inflow.velocity->largest, 0.2 / 0.18, 1e-12);
    EXPECT_NEAR(flow.outflow.froude->largest, 1.0, 1e-12);
    EXPECT_THAT(text_of(c), HasSubstr("q = 0.04 to 0.2 m2/s by flood.csv"));
    EXPECT_THAT(text_of(c), HasSubstr("holds the critical depth, 54.64 to 159.8 mm"));
}

// Water on a solid at an end is as deep as it is over that.
TEST(FlowAtEnds, OverASolidTheDepthIsThatAboveIt) {
    const Case c = slip_case(
        "[inflow]\nunit_discharge = \"0.03 m2/s\"\nprofile = \"uniform\"\n[outflow]\nkind = \"free\"\n"
        "[[solid]]\nname = \"step\"\nx = [\"-0.2 m\", \"0.5 m\", \"0.5 m\", \"-0.2 m\"]\n"
        "z = [\"0 mm\", \"0 mm\", \"100 mm\", \"100 mm\"]\nsurface = \"slip\"\n");
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_NEAR(flow.inflow.depth->least, 0.18, 1e-12);
    EXPECT_NEAR(flow.inflow.velocity->least, 0.03 / 0.08, 1e-12);
    EXPECT_FALSE(flow.outflow.depth);
    EXPECT_THAT(text_of(c), HasSubstr("depth 180 mm (80 mm over the solid there)"));
}

// On the bed of a twin: the uniform flow of condition 2, whose velocity counts over the datum.
TEST(FlowAtEnds, UniformFlowIsThatOfTheTwin) {
    const Case c = rough_case("[inflow]\ndischarge = \"7.9917 l/s\"\n");
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_NEAR(flow.held_depth->least, 0.05, 1e-5);
    EXPECT_EQ(flow.inflow.source, DepthSource::backwater);
    EXPECT_NEAR(flow.inflow.depth->least, 0.05, 1e-5);
    EXPECT_NEAR(flow.outflow.normal_depth->least, 0.05, 1e-5);
    EXPECT_NEAR(flow.inflow.velocity->least, 0.335, 0.001);
    EXPECT_THAT(text_of(c), HasSubstr("(7.992 l/s over the width of 459 mm)"));
    EXPECT_THAT(text_of(c), HasSubstr("(a mild slope)"));
}

// Behind a free outflow nothing holds the water of a mild slope: it leaves at the critical depth.
TEST(FlowAtEnds, SlowWaterLeavesAFreeOutflowAtTheCriticalDepth) {
    const FlowAtEnds flow =
        flow_at_ends(rough_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n[outflow]\nkind = \"free\"\n"));
    EXPECT_NEAR(flow.outflow.depth->least, flow.outflow.critical_depth->least, 1e-6);
    EXPECT_NEAR(flow.outflow.froude->least, 1.0, 1e-3);
    EXPECT_LT(flow.inflow.depth->least, 0.05);
}

// What is forgotten last: the water of the start behind a free outflow, else what the outflow is still to
// hold.
TEST(FlowAtEnds, TheStartIsForgottenWhenAllWaterIsReplaced) {
    const std::string inflow = "[inflow]\nunit_discharge = \"0.03 m2/s\"\nprofile = \"uniform\"\n[outflow]\n";
    EXPECT_NEAR(relaxation_time_between_ends(slip_case(inflow + "kind = \"free\"\n")), 0.18 * 1.4 / 0.03,
                1e-9);
    EXPECT_NEAR(relaxation_time_between_ends(
                    slip_case(inflow + "kind = \"depth\"\ndepth = \"0.2 m\"\nrelaxation_time = \"30 s\"\n")),
                30.0, 1e-9);
}

// A hydrograph over a bed that goes on behind the outflow: it holds the depth of uniform flow with what
// leaves.
TEST(FlowAtEnds, AHydrographLeavesWithTheNormalDepthOfWhatLeaves) {
    test::TemporaryFolder folder;
    Case c = rough_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n[start]\nkind = \"backwater\"\n");
    const double steady = flow_at_ends(c).held_depth->least;
    c.inflow.unit_discharge.reset();
    c.inflow.discharge_file = folder.path() / "hydrograph.csv";
    std::ofstream(c.inflow.discharge_file)
        << "time [s],unit_discharge [m2/s]\n0,0.0174\n5,0.0174\n15,0.04\n30,0.0174\n";
    c.run.time = 20.0;
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_NEAR(flow.held_depth->least, steady, 1e-5 * steady);
    EXPECT_GT(flow.held_depth->largest, 1.5 * steady);
    EXPECT_EQ(flow.inflow.source, DepthSource::uniform);
    EXPECT_NEAR(flow.inflow.depth->largest, flow.held_depth->largest, 1e-5 * steady);
    EXPECT_NEAR(flow.outflow.normal_depth->largest, flow.held_depth->largest, 1e-5 * steady);
    // The run starts with the steady flow of the first row.
    EXPECT_NEAR(start_depths(c, read_end_levels(c))(0.3), steady + c.datum(), 1e-4 * steady);
}

// Where the outflow holds another depth than that of uniform flow, the inflow has that of the steady flow
// between them with each discharge: the same as that of the discharge alone, and the time in which the
// outflow follows is told.
TEST(FlowAtEnds, AHydrographOverARatingCurveHasTheDepthsOfItsSteadyFlows) {
    test::TemporaryFolder folder;
    std::ofstream(folder.path() / "rating.csv")
        << "depth [m],unit_discharge [m2/s]\n0.07,0.0174\n0.11,0.04\n";
    std::ofstream(folder.path() / "flood.csv")
        << "time [s],unit_discharge [m2/s]\n0,0.0174\n5,0.04\n9,0.0174\n";
    Case c = rough_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n[start]\nkind = \"backwater\"\n");
    c.outflow.kind = OutflowKind::rating_curve;
    c.outflow.rating_file = folder.path() / "rating.csv";
    const double of_first = flow_at_ends(c).inflow.depth->least;
    c.inflow.unit_discharge = 0.04;
    const double of_second = flow_at_ends(c).inflow.depth->least;
    EXPECT_GT(of_first, 0.066);  // the normal depth is 50 mm
    c.inflow.unit_discharge.reset();
    c.inflow.discharge_file = folder.path() / "flood.csv";
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_EQ(flow.inflow.source, DepthSource::steady);
    EXPECT_NEAR(flow.inflow.depth->least, of_first, 1e-9);
    EXPECT_NEAR(flow.inflow.depth->largest, of_second, 1e-9);
    EXPECT_THAT(text_of(c), HasSubstr("it follows that in some"));
    // A depth by a file lets in and out the water that its change takes.
    c.outflow.kind = OutflowKind::depth;
    c.outflow.depth_file = folder.path() / "tide.csv";
    std::ofstream(c.outflow.depth_file) << "time [s],depth [m]\n0,0.06\n5,0.09\n9,0.06\n";
    EXPECT_THAT(text_of(c), HasSubstr("a change by the file is followed at once"));
}

std::string error_of_ends(const Case& c) {
    try {
        static_cast<void>(read_end_levels(c));
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// Nothing holds water below the critical depth of what leaves at that time.
TEST(FlowAtEnds, AnOutflowBelowTheCriticalDepthIsRefused) {
    test::TemporaryFolder folder;
    Case c = slip_case(
        "[inflow]\nunit_discharge = \"0.03 m2/s\"\nprofile = \"uniform\"\n[outflow]\nkind = \"critical-depth\"\n");  // 45.1 mm
    c.outflow.kind = OutflowKind::weir;
    c.outflow.weir_height = 0.001;
    c.outflow.weir_coefficient = 1.2;
    EXPECT_THAT(error_of_ends(c), HasSubstr("whose critical depth is 45.1"));
    EXPECT_THAT(error_of_ends(c), HasSubstr("raise weir_height"));
    c.outflow.weir_coefficient = 0.6;
    EXPECT_EQ(error_of_ends(c), "");
    c.outflow.kind = OutflowKind::rating_curve;
    c.outflow.rating_file = folder.path() / "rating.csv";
    std::ofstream(c.outflow.rating_file) << "depth [m],unit_discharge [m2/s]\n0.02,0.01\n0.04,0.05\n";
    EXPECT_THAT(error_of_ends(c), HasSubstr("rating.csv: the rating curve holds 30 mm"));
    // A table is deep enough for the discharge of its time, or not.
    c.outflow.kind = OutflowKind::depth;
    c.outflow.depth_file = folder.path() / "tide.csv";
    c.inflow.unit_discharge.reset();
    c.inflow.discharge_file = folder.path() / "flood.csv";
    std::ofstream(c.inflow.discharge_file) << "time [s],unit_discharge [m2/s]\n0,0.01\n3,0.03\n9,0.03\n";
    std::ofstream(c.outflow.depth_file) << "time [s],depth [m]\n0,0.03\n3,0.06\n9,0.06\n";
    EXPECT_EQ(error_of_ends(c), "");
    std::ofstream(c.outflow.depth_file) << "time [s],depth [m]\n0,0.06\n3,0.03\n9,0.06\n";
    EXPECT_THAT(error_of_ends(c),
                HasSubstr("tide.csv: it holds 30 mm at the discharge of 0.03 m2/s (t = 3 s)"));
    // So is one depth under a hydrograph, also one that begins with nothing.
    std::ofstream(c.inflow.discharge_file) << "time [s],unit_discharge [m2/s]\n0,0\n3,0.03\n9,0.03\n";
    c.outflow.depth_file.clear();
    c.outflow.depth = 0.03;
    EXPECT_THAT(error_of_ends(c), HasSubstr("[outflow] depth: it holds 30 mm"));
    c.outflow.depth = 0.06;
    EXPECT_EQ(error_of_ends(c), "");
    // A rating curve has rows of its own between those of the hydrograph.
    c.outflow.kind = OutflowKind::rating_curve;
    std::ofstream(c.outflow.rating_file)
        << "depth [m],unit_discharge [m2/s]\n0.001,0\n0.007,0.012\n0.06,0.014\n0.08,0.031\n";
    EXPECT_THAT(error_of_ends(c), HasSubstr("the rating curve holds"));
}

// What is watched beside the ends is a share of the depth that the case names; a file may ask for four times
// it.
TEST(FlowAtEnds, AStretchThatIsShortForTheHighestWaterIsTold) {
    const test::TemporaryFolder folder;
    Case c = rough_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n");
    c.numerics.spacing = 0.001;
    c.outflow.kind = OutflowKind::depth;
    c.outflow.depth_file = folder.path() / "tide.csv";
    std::ofstream(c.outflow.depth_file) << "time [s],depth [m]\n0,0.06\n5,0.08\n";
    EXPECT_THAT(text_of(c), Not(HasSubstr("the discharge may swing")));
    std::ofstream(c.outflow.depth_file) << "time [s],depth [m]\n0,0.06\n5,0.18\n";
    EXPECT_THAT(text_of(c), HasSubstr("the discharge may swing"));
}

// A supercritical inflow is told to need its depth.
TEST(FlowAtEnds, OfASteepSlopeAsksForTheDepth) {
    Case c = rough_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n");
    EXPECT_THAT(text_of(c), Not(HasSubstr("give the depth")));
    c.channel.slope = 0.1;
    EXPECT_THAT(text_of(c), HasSubstr("Without [inflow] depth the water enters at the critical depth"));
}

// Where the jump stands, or that it does not, is known before the run.
TEST(FlowAtEnds, TellsWhereAJumpStands) {
    const auto jump = [](const char* depth) {
        return parse_case(
            std::string("[channel]\nslope = 0\ndepth = \"70 mm\"\nlength = \"1 m\"\nends = \"open\"\n"
                        "[bed]\nkind = \"roughness\"\nequivalent_roughness = \"1 mm\"\n"
                        "[numerics]\nspacing = \"2 mm\"\n[start]\nkind = \"backwater\"\n"
                        "[run]\nuntil = \"5 s\"\n[inflow]\nunit_discharge = \"0.02658 m2/s\"\n"
                        "depth = \"20 mm\"\n[outflow]\nkind = \"depth\"\ndepth = \"") +
                depth + "\"\n",
            "test");
    };
    EXPECT_THAT(text_of(jump("70 mm")), HasSubstr("riffle backwater: a hydraulic jump at x = 0.49"));
    EXPECT_THAT(text_of(jump("95 mm")),
                HasSubstr("riffle backwater: The jump is drowned at the upstream end"));
    EXPECT_THAT(text_of(rough_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n")),
                Not(HasSubstr("riffle backwater: ")));
}

// Each end has the depths of the bed there.
TEST(FlowAtEnds, OverTwoBedsHasTheDepthsOfBoth) {
    const Case c = parse_case(
        "[channel]\nslope = 0.003\ndepth = \"60 mm\"\nlength = \"1.5 m\"\nends = \"open\"\n"
        "[inflow]\nunit_discharge = \"0.03 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"60 mm\"\n"
        "[bed]\nkind = \"roughness\"\nequivalent_roughness = \"1 mm\"\n"
        "[[bed_patch]]\nname = \"cobbles\"\nequivalent_roughness = \"12 mm\"\nx_from = \"0.5 m\"\n"
        "[turbulence]\nclosure = \"nezu-rodi\"\n[numerics]\nspacing = \"6 mm\"\n[run]\nuntil = \"8 s\"\n",
        "test");
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_FALSE(flow.one_bed);
    EXPECT_GT(flow.outflow.normal_depth->least, 1.2 * flow.inflow.normal_depth->least);
    EXPECT_THAT(text_of(c), HasSubstr("of it at the inflow: critical depth "));
    EXPECT_THAT(text_of(c), HasSubstr("of it at the outflow: critical depth "));
}

// Depths count from the datum, 6 mm above the floor: so does that of the formula where no twin has a profile.
TEST(FlowAtEnds, TheCriticalDepthOfTheFormulaIsSaidToBeLessTheDatum) {
    Case c = rough_case(
        "[inflow]\nunit_discharge = \"0.0174 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"50 mm\"\n");
    c.channel.dimensions = 3;
    c.channel.width = 0.1;
    c.turbulence.closure = ClosureKind::wale;
    c.inflow.profile = InflowProfile::uniform;
    // (0.0174^2/9.81)^(1/3) = 31.37 mm.
    EXPECT_THAT(text_of(c), HasSubstr("(q²/g)^(1/3) less the 6 mm up to the datum = 25.37 mm"));
}

// Beyond the points of a profile its last values go on: to be told where that is more than a row.
TEST(FlowAtEnds, AProfileOfAPartOfTheDepthIsTold) {
    test::TemporaryFolder folder;
    Case c = rough_case("[inflow]\nunit_discharge = \"0.0174 m2/s\"\n");
    c.inflow.profile = InflowProfile::file;
    c.inflow.profile_file = folder.path() / "adv.csv";
    std::ofstream(c.inflow.profile_file) << "z [mm],u [m/s]\n20,0.3\n30,0.35\n";
    EXPECT_THAT(text_of(c),
                HasSubstr("adv.csv gives u from 20 mm to 30 mm over the datum alone: its lowest u goes on "
                          "down to -6 mm, the bottom, its highest up to 50 mm, the surface"));
    std::ofstream(c.inflow.profile_file)
        << "z [mm],u [m/s]\n-5.5,0.1\n3,0.2\n12,0.25\n21,0.3\n30,0.35\n39,0.38\n49.5,0.4\n";
    EXPECT_THAT(text_of(c), Not(HasSubstr("profile")));
    std::ofstream(c.inflow.profile_file) << "z [mm],u [m/s]\n-5.5,0.1\n5,0.2\n45,0.38\n49.5,0.4\n";
    EXPECT_THAT(text_of(c),
                HasSubstr("adv.csv: between 5 mm and 45 mm it has no point, and u goes straight"));
    std::ofstream(c.inflow.profile_file) << "z,u\n0,0\n20,0.3\n45,0.35\n";  // meant in mm, read in m
    EXPECT_THAT(error_of_ends(c),
                HasSubstr("2 of its 3 heights, 0 m to 45 m over the datum, lie outside of the water"));
}

TEST(FlowAtEnds, ADuctHasNoFroudeNumber) {
    const Case c = parse_case(
        "[fluid]\nkinematic_viscosity = \"1e-5 m2/s\"\n[channel]\nslope = 0\ndepth = \"20 mm\"\nlength = \"0.3 m\"\n"
        "ends = \"open\"\ntop = \"wall\"\n[inflow]\nunit_discharge = \"1e-3 m2/s\"\n[outflow]\n"
        "kind = \"pressure\"\n[bed]\nkind = \"no-slip\"\n[turbulence]\nclosure = \"none\"\n[start]\n"
        "kind = \"uniform\"\n[numerics]\nspacing = \"1 mm\"\n[run]\nuntil = \"1 s\"\n",
        "test");
    const FlowAtEnds flow = flow_at_ends(c);
    EXPECT_NEAR(flow.inflow.velocity->least, 0.05, 1e-12);
    EXPECT_FALSE(flow.inflow.froude);
    EXPECT_NEAR(*flow.reynolds, 200.0, 1e-9);
}

}  // namespace
}  // namespace riffle
