// Steady flow over beds of several roughnesses, one behind the other.

#include "hydraulics/varied_reaches.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace riffle::varied_reaches_test {
namespace {

constexpr double gravity = 9.81;
constexpr double slope = 0.001;
constexpr double unit_discharge = 1.2;

/// Manning's n, and a momentum coefficient that goes with it.
SteadyChannel bed(double n, double momentum_coefficient = 1.0) {
    SteadyChannel channel = manning_channel(slope, gravity, unit_discharge, n);
    channel.state = [state = channel.state, momentum_coefficient](double depth) {
        SectionState s = state(depth);
        s.momentum_coefficient = momentum_coefficient;
        return s;
    };
    return channel;
}

ChannelControls held_at(double depth) {
    return {.length = 900.0, .upstream_depth = {}, .downstream_depth = depth};
}

TEST(VariedReaches, OfOneBedAreOneChannel) {
    const VariedFlow whole = solve_varied_flow(bed(0.025), held_at(1.6));
    const VariedFlow parts = solve_varied_reaches(
        {{"", 0.0, 300.0, bed(0.025)}, {"same", 300.0, 500.0, bed(0.025)}, {"", 500.0, 900.0, bed(0.025)}},
        held_at(1.6));
    ASSERT_EQ(parts.profiles.size(), 3U);
    for (const double x : {0.0, 120.0, 300.0, 420.0, 500.0, 731.0, 900.0}) {
        EXPECT_NEAR(parts.depth_at(x), whole.depth_at(x), 1e-8) << x;
    }
    ASSERT_EQ(parts.reaches.size(), 3U);
    EXPECT_EQ(parts.reaches[1].name, "same");
    EXPECT_DOUBLE_EQ(*parts.reaches[1].normal_depth, *whole.normal_depth);
}

TEST(VariedReaches, KeepTheMomentumFunctionOverAnEdge) {
    const SteadyChannel smooth = bed(0.012, 1.02);
    const SteadyChannel rough = bed(0.035, 1.10);
    const VariedFlow flow =
        solve_varied_reaches({{"", 0.0, 400.0, smooth}, {"rough", 400.0, 900.0, rough}}, held_at(1.2));
    const double before = flow.profiles[0].depth_to;
    const double behind = flow.profiles[1].depth_from;
    EXPECT_NEAR(smooth.momentum(before), rough.momentum(behind), 1e-9 * rough.momentum(behind));
    // More momentum goes with the rough bed's profile: the depth falls over the edge.
    EXPECT_GT(before, behind + 0.005);
    EXPECT_NEAR(flow.depth_at(900.0), 1.2, 1e-12);
}

/// The momentum balance of a whole reach: what its ends differ by is weight less friction.
TEST(VariedReaches, LoseWhatTheFrictionOfEachBedTakes) {
    const SteadyChannel beds[] = {bed(0.015), bed(0.03)};
    const VariedFlow flow =
        solve_varied_reaches({{"", 0.0, 300.0, beds[0]}, {"rough", 300.0, 900.0, beds[1]}}, held_at(1.5));
    for (std::size_t k = 0; k < 2; ++k) {
        const SurfaceProfile& part = flow.profiles[k];
        constexpr int steps = 4000;
        const double step = (part.to - part.from) / steps;
        double gained = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double depth = part.depth_at(part.from + (i + 0.5) * step);
            gained += step * gravity * depth * beds[k].surplus_slope(depth);
        }
        EXPECT_NEAR(beds[k].momentum(part.depth_to) - beds[k].momentum(part.depth_from), gained, 1e-5);
    }
}

TEST(VariedReaches, AreRefusedWhereTheFlowBecomesSupercritical) {
    // Over the first bed the normal flow is supercritical, and the second does not hold it.
    SteadyChannel steep = bed(0.008);
    steep.slope = 0.02;
    SteadyChannel below = bed(0.02);
    below.slope = 0.02;
    const std::vector<Reach> reaches{{"glass", 0.0, 400.0, steep}, {"", 400.0, 900.0, below}};
    try {
        static_cast<void>(solve_varied_reaches(reaches, held_at(1.5)));
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("supercritical over"), std::string::npos) << error.what();
    }
    ChannelControls shooting = held_at(1.5);
    shooting.upstream_depth = 0.3;
    EXPECT_THROW(static_cast<void>(solve_varied_reaches(reaches, shooting)), InputError);
}

}  // namespace
}  // namespace riffle::varied_reaches_test
