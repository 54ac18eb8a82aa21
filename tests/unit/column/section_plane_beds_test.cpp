// Cross-sections of channels with plane beds, known by k_s, Manning's n or smooth, between side walls by the
// log law.

#include <gtest/gtest.h>

#include <cmath>

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
