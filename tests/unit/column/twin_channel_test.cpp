#include "column/twin_channel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "column/column.hpp"

namespace riffle {
namespace {

Case condition_2() {
    return read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/rough-bed-2d/condition-2.toml");
}

// The normal depth of the discharge of uniform flow is its depth, and the state there that of the twin.
TEST(TwinChannel, CarriesTheUniformFlowOfTheCase) {
    for (const double depth : {0.03, 0.05, 0.1}) {
        Case c = condition_2();
        c.channel.depth = depth;
        const SteadyChannel channel = twin_channel(c, uniform_unit_discharge(c));
        EXPECT_NEAR(*normal_depth(channel), depth, 1e-6 * depth);
        const ColumnResult twin = solve_column(c);
        const SectionState state = channel.state(depth);
        EXPECT_NEAR(state.friction_slope, std::sin(std::atan(c.channel.slope)), 1e-6 * c.channel.slope);
        EXPECT_NEAR(state.mean_velocity, twin.depth_mean_velocity, 1e-6 * twin.depth_mean_velocity);
        EXPECT_NEAR(channel.manning(depth), twin.manning, 1e-5 * twin.manning);
        EXPECT_NEAR(channel.unit_discharge, twin.total_mean_velocity * c.total_depth(),
                    1e-9 * channel.unit_discharge);
        EXPECT_GT(state.momentum_coefficient, 1.0);
        EXPECT_GT(state.energy_coefficient, state.momentum_coefficient);
    }
}

// Between the depths at which the twin is solved the states are interpolated.
TEST(TwinChannel, InterpolatesWhatTheTwinSays) {
    const Case c = condition_2();
    const SteadyChannel channel = twin_channel(c, 0.0174);
    for (const double depth : {0.00405, 0.0043, 0.0213, 0.0377, 0.0619, 0.1204}) {
        Case other = c;
        other.channel.depth = depth;
        // The friction may be more than gravity: the column knows only the product of gravity and slope.
        other.channel.slope = 1e-3;
        other.fluid.gravity *= channel.state(depth).friction_slope / std::sin(std::atan(1e-3));
        // Just over the crests the depths that it interpolates between lie on one side.
        const double bar = depth < 0.005 ? 5e-6 : 2e-6;
        EXPECT_NEAR(uniform_unit_discharge(other), 0.0174, bar * 0.0174) << depth;
    }
}

// A parabola over a smooth bed: beta = 6/5, alpha = 54/35, S_f = 3 nu q/(g h^3).
TEST(TwinChannel, IsExactForLaminarFlow) {
    const Case c = read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/checks/laminar-re10.toml");
    const double q = uniform_unit_discharge(c);
    const SteadyChannel channel = twin_channel(c, q);
    for (const double share : {0.8, 1.0, 1.37}) {
        const double h = share * c.channel.depth;
        const SectionState state = channel.state(h);
        EXPECT_NEAR(state.momentum_coefficient, 1.2, 1e-4);
        EXPECT_NEAR(state.energy_coefficient, 54.0 / 35.0, 1e-4);
        EXPECT_NEAR(state.friction_slope,
                    3.0 * c.fluid.kinematic_viscosity * q / (c.fluid.gravity * h * h * h),
                    1e-4 * state.friction_slope);
    }
}

// Shooting water over a rough bed is braked faster than it would fall.
TEST(TwinChannel, KnowsFrictionBeyondGravity) {
    const SteadyChannel channel = twin_channel(condition_2(), 0.06);
    EXPECT_GT(channel.state(0.012).friction_slope, 1.0);
}

// Between side walls the friction is that of bed and walls: the section twin's.
TEST(TwinChannel, SideWallsBrakeToo) {
    Case c = read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/rough-bed-3d/condition-2-coarse.toml");
    c.channel.width = 0.2;  // four depths: the walls count
    ASSERT_TRUE(c.has_side_walls());
    const double q = uniform_unit_discharge(c);
    const SteadyChannel channel = twin_channel(c, q);
    EXPECT_NEAR(*normal_depth(channel), c.channel.depth, 2e-3 * c.channel.depth);
    Case wide = c;
    wide.channel.sides = Sides::periodic;
    EXPECT_LT(q, 0.95 * uniform_unit_discharge(wide));
    EXPECT_GT(channel.state(0.05).friction_slope, 1.1 * twin_channel(wide, q).state(0.05).friction_slope);
    EXPECT_GT(channel.state(0.05).energy_coefficient, twin_channel(wide, q).state(0.05).energy_coefficient);
    // Whatever the discharge: the section of that slope carries it.
    const CarryingSection carrying = carrying_section(c, 0.04, 0.02);
    EXPECT_NEAR(carrying.section.discharge / c.channel.width, 0.02, 1e-8);
    EXPECT_GE(carrying.section.momentum_coefficient, 1.0);
    Case other = c;
    other.channel.depth = 0.04;
    other.channel.slope = std::tan(std::asin(carrying.weight / c.fluid.gravity));
    EXPECT_NEAR(uniform_unit_discharge(other), 0.02, 1e-3 * 0.02);  // on another grid
    EXPECT_NEAR(*twin_normal_depth(other, 0.02), 0.04, 1e-5 * 0.04);
    // A horizontal channel has that twin too, and what carries hardly anything is said to be too shallow.
    other.channel.slope = 0.0;
    EXPECT_TRUE(has_section_reach(other));
    try {
        static_cast<void>(twin_normal_depth(c, 1e-7));
        FAIL() << "no error";
    } catch (const InputError& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr("below which the friction of the bed is not known"));
    }
}

// A run may begin with a dry bed before a gate: the water that enters is that of the channel all the same.
TEST(TwinChannel, OfAnOpenChannelKnowsNoOutlineOfTheStart) {
    Case c = read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/open-ends/hydraulic-jump.toml");
    const double weight = carrying_column(c, 0.05, 0.02).weight;
    c.start.kind = StartKind::rest;
    c.start.water_x = {0.0, 0.3, 0.3, 0.0};
    c.start.water_z = {0.0, 0.0, 0.05, 0.05};
    EXPECT_EQ(carrying_column(c, 0.05, 0.02).weight, weight);
}

TEST(TwinChannel, NeedsAColumn) {
    const Case c = read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/checks/flow-over-step.toml");
    try {
        static_cast<void>(twin_channel(c, 0.01).state(0.05));
        FAIL() << "no error";
    } catch (const InputError& e) {
        EXPECT_THAT(e.what(), testing::HasSubstr("no column twin"));
    }
}

}  // namespace
}  // namespace riffle
