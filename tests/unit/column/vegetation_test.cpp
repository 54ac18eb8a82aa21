// The twins of channels with vegetation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/flow_kind.hpp"
#include "column/column.hpp"
#include "column/section.hpp"
#include "column/twin_channel.hpp"
#include "roughness/stem_drag.hpp"
#include "vegetated_channel.hpp"

namespace riffle::vegetated_column_test {
namespace {

using testing::HasSubstr;

Case channel(double height) {
    Case c = test::slip_channel(0.002, 0.2);
    c.numerics.spacing = 0.01;
    c.vegetation = {test::stems(300.0, 0.006, height, 1.1)};
    return c;
}

TEST(VegetatedColumn, OfEmergentStemsIsUniform) {
    Case c = channel(1.0);
    const auto expect_uniform = [&c] {
        const StemDrag drag(c.vegetation.front(), c.fluid.kinematic_viscosity);
        const ColumnResult column = solve_column(c);
        const double u = drag.speed_at(c.streamwise_gravity());
        EXPECT_NEAR(column.depth_mean_velocity, u, 1e-6 * u);
        EXPECT_NEAR(column.surface_velocity, u, 1e-6 * u);
        EXPECT_NEAR(column.vegetation_share, 1.0, 1e-9);
        // Of du/dt = g S0 - f(u).
        EXPECT_NEAR(column.relaxation_time, 1.0 / drag.deceleration_slope(u), 1e-5);
    };
    expect_uniform();
    const double phi = c.vegetation.front().solid_fraction();
    EXPECT_NEAR(solve_column(c).depth_mean_velocity,
                std::sqrt(2.0 * c.streamwise_gravity() * (1.0 - phi) / (1.1 * 300.0 * 0.006)), 1e-7);
    c.vegetation.front().drag_coefficient.reset();
    expect_uniform();
    c.vegetation.front().vogel_exponent = -0.8;
    c.vegetation.front().reference_velocity = 0.05;
    expect_uniform();
}

TEST(VegetatedColumn, CarriesTheWeightByStemsAndBed) {
    Case c = channel(0.08);
    c.bed.kind = BedKind::roughness;
    c.bed.equivalent_roughness = 0.005;
    const ColumnResult column = solve_column(c);
    EXPECT_NEAR(column.vegetation_share + column.drag_share, 1.0, 1e-9);
    EXPECT_GT(column.vegetation_share, 0.9);
    EXPECT_FALSE(column.log_law.valid);
    const ColumnResult half = solve_column(c, 500);
    EXPECT_NEAR(half.depth_mean_velocity, column.depth_mean_velocity, 1e-4 * column.depth_mean_velocity);
    c.vegetation.clear();
    EXPECT_LT(column.depth_mean_velocity, 0.6 * solve_column(c).depth_mean_velocity);
}

TEST(VegetatedColumn, OverSpheresAndOfEveryMixingLength) {
    for (const ClosureKind closure : {ClosureKind::ramp, ClosureKind::nezu_rodi, ClosureKind::nikuradse,
                                      ClosureKind::czernuszenko_rylov}) {
        Case c = channel(0.08);
        c.turbulence.closure = closure;
        c.bed.kind = BedKind::spheres;
        c.bed.roughness_height = 0.01;
        c.bed.datum_below_crest = 0.004;
        const ColumnResult column = solve_column(c);
        EXPECT_NEAR(column.vegetation_share + column.drag_share, 1.0, 1e-9);
    }
}

TEST(VegetatedColumn, IsNoneOfPatches) {
    Case c = channel(0.08);
    EXPECT_EQ(flow_kind(c), FlowKind::uniform_channel);
    c.vegetation.front().x_to = 0.2;
    EXPECT_EQ(flow_kind(c), FlowKind::channel_with_bodies);
    EXPECT_TRUE(uses_local_depth(c));
    EXPECT_THAT(why_no_column(c).value_or(""),
                HasSubstr("\"reeds\" stands in a part of the channel's length"));
    // A far reach of a channel with open ends has none.
    c.channel.ends = Ends::open;
    EXPECT_TRUE(uniform_reach(c).vegetation.empty());
    c = channel(0.08);
    c.channel.dimensions = 3;
    c.vegetation.front().y_to = 0.1;
    EXPECT_THAT(why_no_column(c).value_or(""), HasSubstr("in a part of the channel's width"));
    EXPECT_EQ(flow_kind(c), FlowKind::uniform_channel);
    c.channel.ends = Ends::open;
    c = channel(0.08);
    EXPECT_EQ(uniform_reach(c).vegetation.size(), 1U);
}

Case between_walls(double y_to) {
    Case c = channel(1.0);
    c.channel.dimensions = 3;
    c.channel.width = 1.2;
    c.channel.sides = Sides::half;
    c.side_walls.drag_form = SideDragForm::none;
    c.turbulence.closure = ClosureKind::czernuszenko_rylov;
    if (y_to > 0.0) c.vegetation.front().y_to = y_to;
    return c;
}

TEST(VegetatedSection, OfStemsEverywhereIsTheColumn) {
    const Case c = between_walls(0.0);
    const SectionResult section = solve_section(c);
    EXPECT_NEAR(section.depth_mean_velocity, solve_column(c).depth_mean_velocity, 1e-6);
    EXPECT_NEAR(section.vegetation_share, 1.0, 1e-9);
}

TEST(VegetatedSection, FollowsThePatchAcrossTheChannel) {
    Case c = between_walls(0.3);
    c.bed.kind = BedKind::spheres;
    c.bed.roughness_height = 0.01;
    c.bed.datum_below_crest = 0.004;
    ASSERT_FALSE(why_no_section(c));
    const SectionResult section = solve_section(c);
    EXPECT_NEAR(section.vegetation_share + section.drag_share, 1.0, 1e-6);
    // Far from the edge the velocity is that of the stems alone, or of the bed.
    Case stems = c;
    stems.vegetation.front().y_to.reset();
    EXPECT_NEAR(section.velocity_at(0.05, 0.12), solve_column(stems).velocity_at(0.12), 0.01);
    EXPECT_GT(section.velocity_at(0.6, 0.12), 2.0 * section.velocity_at(0.05, 0.12));
}

TEST(VegetatedSection, NeedsASymmetricChannel) {
    Case c = between_walls(0.3);
    c.channel.sides = Sides::walls;
    EXPECT_THAT(why_no_section(c).value_or(""), HasSubstr("no mirror image"));
    c.vegetation.push_back(c.vegetation.front());
    c.vegetation.back().name = "sedges";
    c.vegetation.back().y_from = 0.9;
    c.vegetation.back().y_to = 1.2;
    EXPECT_FALSE(why_no_section(c));
    c.vegetation.back().height = 0.05;
    EXPECT_TRUE(why_no_section(c));
    c = between_walls(0.3);
    c.vegetation.front().x_to = 0.2;
    EXPECT_THAT(why_no_section(c).value_or(""), HasSubstr("part of the channel's length"));
}

}  // namespace
}  // namespace riffle::vegetated_column_test
