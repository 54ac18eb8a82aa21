// Cross-sections of channels with plane beds, known by k_s, Manning's n or smooth, between side walls by the
// log law.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "column/column.hpp"
#include "column/section.hpp"

namespace riffle::section_plane_beds_test {
namespace {

/// A channel 100 mm deep and 400 mm wide.
Case channel(BedKind kind) {
    Case c;
    c.channel.dimensions = 3;
    c.channel.sides = Sides::half;
    c.channel.depth = 0.1;
    c.channel.width = 0.4;
    c.channel.slope = 0.001;
    c.bed.kind = kind;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    if (kind == BedKind::roughness) c.bed.equivalent_roughness = 2e-3;
    c.turbulence.closure = ClosureKind::czernuszenko_rylov;
    c.numerics.spacing = 0.005;
    c.side_walls.drag_form = SideDragForm::log_law;
    return c;
}

constexpr SectionOptions coarse{.cells_across = 24, .cells_over_depth = 60};

TEST(SectionOverPlaneBeds, BalancesItsWeight) {
    for (const BedKind kind : {BedKind::roughness, BedKind::smooth}) {
        for (const SideDragForm form :
             {SideDragForm::log_law, SideDragForm::consistent, SideDragForm::none}) {
            Case c = channel(kind);
            c.side_walls.drag_form = form;
            const SectionResult r = solve_section(c, coarse);
            EXPECT_NEAR(r.drag_share + r.side_wall_share, 1.0, 1e-9);
            EXPECT_EQ(r.side_wall_share > 0.0, form != SideDragForm::none);
            if (form == SideDragForm::consistent) {
                EXPECT_NEAR(r.drag_share, r.partition.bed_share, 1e-9);
            }
            if (form == SideDragForm::log_law) {
                EXPECT_GT(r.centreline_velocity, 1.1 * r.wall_layer_velocity);
            }
        }
    }
}

TEST(SectionOverPlaneBeds, BetweenFrictionlessWallsIsTheColumn) {
    for (const BedKind kind : {BedKind::roughness, BedKind::smooth}) {
        Case c = channel(kind);
        c.side_walls.drag_form = SideDragForm::none;
        c.turbulence.closure = ClosureKind::nezu_rodi;
        const SectionResult r = solve_section(c, {.cells_across = 8});
        const ColumnResult column = solve_column(c);
        // Both have an error of a tenth of a percent from their rows.
        EXPECT_NEAR(r.centreline_velocity, column.depth_mean_velocity, 2e-3 * column.depth_mean_velocity);
        EXPECT_NEAR(r.velocity_at(0.0, 0.05), column.velocity_at(0.05), 2e-3 * column.velocity_at(0.05));
        EXPECT_NEAR(r.relaxation_time, column.relaxation_time, 2e-3 * column.relaxation_time);
    }
}

/// The same with a strip along the middle, from a fourth of the width on.
Case channel_with_strip(double roughness) {
    Case c = channel(BedKind::roughness);
    c.turbulence.closure = ClosureKind::nezu_rodi;
    BedPatch strip;
    strip.name = "strip";
    strip.equivalent_roughness = roughness;
    strip.y_from = 0.25 * c.channel.width;
    c.bed_patches = {strip};
    return c;
}

TEST(SectionOverPlaneBeds, AStripOfTheSameBedChangesNothing) {
    Case c = channel_with_strip(2e-3);
    const SectionResult with = solve_section(c, coarse);
    c.bed_patches.clear();
    const SectionResult without = solve_section(c, coarse);
    // The grid has a face at the edge of the strip.
    EXPECT_NEAR(with.discharge, without.discharge, 1e-3 * without.discharge);
    EXPECT_NEAR(with.centreline_velocity, without.centreline_velocity, 1e-3 * without.centreline_velocity);
}

TEST(SectionOverPlaneBeds, ARoughStripHoldsTheWaterBack) {
    const Case c = channel_with_strip(2e-2);
    const SectionResult r = solve_section(c, coarse);
    EXPECT_NEAR(r.drag_share + r.side_wall_share, 1.0, 1e-9);
    // Each bed slows the water over it, and the eddies share it out between them: between the two flows of
    // one bed.
    Case rough = channel(BedKind::roughness);
    rough.turbulence.closure = ClosureKind::nezu_rodi;
    const double over_smoother = solve_section(rough, coarse).centreline_velocity;
    rough.bed.equivalent_roughness = 2e-2;
    const double over_rougher = solve_section(rough, coarse).centreline_velocity;
    EXPECT_GT(r.centreline_velocity, over_rougher);
    EXPECT_LT(r.centreline_velocity, over_smoother);
    EXPECT_LT(r.centreline_velocity, r.velocity_at(0.06, 0.05));
}

// Far from its edge and from the walls a strip has the flow of its bed alone.
TEST(SectionOverPlaneBeds, TheMiddleOfAWideStripIsTheColumnOfItsBed) {
    Case c = channel_with_strip(2e-2);
    c.channel.width = 4.0;
    c.bed_patches.front().y_from = 1.0;
    c.side_walls.drag_form = SideDragForm::none;
    const SectionResult r = solve_section(c, coarse);
    for (const auto& [y, roughness] : {std::pair{0.0, 2e-3}, std::pair{2.0, 2e-2}}) {
        Case alone = c;
        alone.bed_patches.clear();
        alone.bed.equivalent_roughness = roughness;
        const double expected = solve_column(alone).velocity_at(0.05);
        EXPECT_NEAR(r.velocity_at(y, 0.05), expected, 0.01 * expected) << "k_s = " << roughness;
    }
}

TEST(SectionOverPlaneBeds, StripsAreAsItsMirrorImageAndPlane) {
    Case c = channel_with_strip(2e-2);
    c.channel.sides = Sides::walls;
    c.bed_patches.front().y_to = 0.15;
    EXPECT_NE(why_no_section(c).value_or("").find("has no mirror image"), std::string::npos);
    BedPatch other = c.bed_patches.front();
    other.name = "other";
    other.y_from = 0.25;
    other.y_to = 0.3;
    c.bed_patches.push_back(other);
    EXPECT_FALSE(why_no_section(c).has_value());
    c.bed_patches.front().x_to = 0.1;
    c.bed_patches.back().x_to = 0.1;
    EXPECT_NE(why_no_section(c).value_or("").find("does not lie all along the channel"), std::string::npos);
}

TEST(SectionOverPlaneBeds, HalvingTheRowsChangesNothingByATenthOfAPercent) {
    // That halving the cells across does no more is seen over spheres.
    const Case c = channel(BedKind::smooth);
    constexpr SectionOptions usual{.cells_across = 16};
    const SectionResult r = solve_section(c, usual);
    const SectionResult fine = solve_section(
        c, {.cells_across = usual.cells_across, .cells_over_depth = 2 * usual.cells_over_depth});
    const auto close = [](double a, double b) { EXPECT_NEAR(a, b, 1e-3 * std::abs(b)); };
    close(r.bulk_velocity, fine.bulk_velocity);
    close(r.centreline_velocity, fine.centreline_velocity);
    close(r.wall_layer_velocity, fine.wall_layer_velocity);
    close(r.side_wall_share, fine.side_wall_share);
}

/// Mean velocity of a channel by the law of Colebrook with the hydraulic radius R in place of a quarter of
/// the diameter: 1/sqrt(f) = -2 lg(k_s/(14.8 R) + 2.51/(4 R U/nu sqrt(f))), U = sqrt(8 g R S/f).
double colebrook(const Case& c) {
    const double radius = c.channel.depth * c.channel.width / (c.channel.width + 2.0 * c.channel.depth);
    const double friction_velocity = std::sqrt(c.streamwise_gravity() * radius);
    const double rough = c.bed.equivalent_roughness.value_or(0.0) / (14.8 * radius);
    const double smooth =
        2.51 * c.fluid.kinematic_viscosity / (4.0 * radius * friction_velocity * std::sqrt(8.0));
    return friction_velocity * std::sqrt(8.0) * -2.0 * std::log10(rough + smooth);
}

TEST(SectionOverPlaneBeds, DischargeIsThatOfTheHydraulicRadius) {
    for (const BedKind kind : {BedKind::roughness, BedKind::smooth}) {
        for (const double width : {0.2, 0.4, 1.2}) {
            Case c = channel(kind);
            c.channel.width = width;
            c.turbulence.wake_strength = 0.0;  // pipes, of which the law is, have none
            const SectionResult r = solve_section(c, {.cells_across = 16});

            // The law itself is some per cent off where the section is no circle.
            EXPECT_NEAR(r.bulk_velocity, colebrook(c), 0.03 * colebrook(c));
        }
    }
}

}  // namespace
}  // namespace riffle::section_plane_beds_test
