#include "column/section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "column/calibration.hpp"
#include "column/column.hpp"
#include "column/section_start.hpp"

namespace riffle::section_test {
namespace {

using testing::HasSubstr;

/// Flow condition 2 of the thesis between its side walls.
Case condition_2() {
    Case c;
    c.channel.dimensions = 3;
    c.channel.sides = Sides::half;
    c.channel.depth = 0.050;
    c.channel.slope = 0.004;
    c.bed.roughness_height = 0.010;
    c.turbulence.closure = ClosureKind::czernuszenko_rylov;
    return c;
}

/// Enough for what does not depend on the grid.
constexpr SectionOptions coarse{.cells_across = 24, .cells_over_depth = 30};

struct Condition {
    int number;
    double depth;
    double slope;
    double roughness_over_diameter;
};
constexpr Condition conditions[] = {{1, .040, .004, .40}, {2, .050, .004, .40}, {3, .060, .002, .40},
                                    {4, .070, .002, .40}, {5, .070, .003, .40}, {6, .080, .003, .32},
                                    {7, .090, .003, .32}, {8, .100, .002, .32}};

Case flume(const Condition& k, DragForm form) {
    Case c = condition_2();
    c.channel.depth = k.depth;
    c.channel.slope = k.slope;
    c.bed.roughness_height = k.roughness_over_diameter * c.bed.sphere_diameter;
    c.bed.drag_form = form;
    return c;
}

TEST(Section, EveryConditionBalancesItsWeightAndDividesItAsYangAndLim) {
    for (const Condition& k : conditions) {
        for (const DragForm form : {DragForm::consistent, DragForm::slice, DragForm::thesis}) {
            const SectionResult r = solve_section(flume(k, form), coarse);
            EXPECT_NEAR(r.drag_share + r.side_wall_share, 1.0, 1e-10) << k.number;
            EXPECT_NEAR(r.drag_share, r.partition.bed_share, 1e-10) << k.number;
            EXPECT_NEAR(r.bed_stress, 1000.0 * r.partition.bed_stress, 1e-9) << k.number;
            EXPECT_NEAR(r.wall_stress, 1000.0 * r.partition.wall_stress, 1e-9) << k.number;
            // Slower towards the wall, and nowhere backwards.
            EXPECT_GT(*std::min_element(r.velocity.begin(), r.velocity.end()), 0.0) << k.number;
            EXPECT_LT(r.wall_layer_velocity, 0.5 * r.centreline_velocity) << k.number;
        }
    }
}

TEST(Section, BalancesItsWeightWithThePrintedAndWithoutWallDrag) {
    for (const SideDragForm form : {SideDragForm::thesis, SideDragForm::none}) {
        Case c = condition_2();
        c.side_walls.drag_form = form;
        const SectionResult r = solve_section(c, coarse);
        EXPECT_NEAR(r.drag_share + r.side_wall_share, 1.0, 1e-10);
        EXPECT_EQ(r.side_wall_share == 0.0, form == SideDragForm::none);
    }
}

TEST(Section, HalvingTheGridChangesNothingByATenthOfAPercent) {
    const Case c = condition_2();
    const SectionOptions usual;
    const SectionResult r = solve_section(c, usual);
    const SectionResult fine = solve_section(
        c, {.cells_across = 2 * usual.cells_across, .cells_over_depth = 2 * usual.cells_over_depth});
    const auto close = [](double a, double b) { EXPECT_NEAR(a, b, 1e-3 * std::abs(b)); };
    close(r.bulk_velocity, fine.bulk_velocity);
    close(r.depth_mean_velocity, fine.depth_mean_velocity);
    close(r.centreline_velocity, fine.centreline_velocity);
    close(r.maximum_velocity, fine.maximum_velocity);
    close(r.wall_layer_velocity, fine.wall_layer_velocity);
    close(r.discharge, fine.discharge);
    close(r.relaxation_time, fine.relaxation_time);
}

TEST(Section, HalfIsHalfOfTheWhole) {
    Case c = condition_2();
    const SectionResult half = solve_section(c, coarse);
    c.channel.sides = Sides::walls;
    const SectionResult whole = solve_section(c, coarse);
    ASSERT_EQ(whole.y.size(), 2 * half.y.size());
    EXPECT_EQ(whole.discharge, half.discharge);
    EXPECT_EQ(whole.centreline_velocity, half.centreline_velocity);
    EXPECT_EQ(whole.wall_stress, half.wall_stress);
    for (const double y : {0.0, 0.004, 0.05, 0.2, 0.2295}) {
        for (const double z : {0.001, 0.01, 0.03, 0.056}) {
            EXPECT_NEAR(whole.velocity_at(y, z), half.velocity_at(y, z), 1e-12);
            EXPECT_NEAR(whole.velocity_at(c.channel.width - y, z), half.velocity_at(y, z), 1e-12);
        }
    }
    // The stress across is odd about the centreline.
    const std::size_t row = 20 * whole.y.size();
    EXPECT_EQ(whole.lateral_shear_stress[row + 3], -whole.lateral_shear_stress[row + whole.y.size() - 1 - 3]);
    EXPECT_GT(whole.lateral_shear_stress[row + 3], 0.0);
}

TEST(Section, CentrelineOfAVeryWideChannelIsTheColumn) {
    Case c = condition_2();
    c.channel.width = 40.0 * c.total_depth();
    c.side_walls.drag_form = SideDragForm::none;
    for (const DragForm form : {DragForm::consistent, DragForm::slice, DragForm::thesis}) {
        c.bed.drag_form = form;
        const SectionResult r = solve_section(c);
        const ColumnResult column = solve_column(c);
        EXPECT_NEAR(r.centreline_velocity, column.depth_mean_velocity, 1e-3 * column.depth_mean_velocity);
        EXPECT_NEAR(r.velocity_at(c.channel.centreline(), 0.04), column.velocity_at(0.04),
                    1e-3 * column.velocity_at(0.04));
    }
}

TEST(Section, WithoutWallsEffectsIsTheColumnEverywhere) {
    // A mixing length that knows no side walls, and no drag at them.
    Case c = condition_2();
    c.side_walls.drag_form = SideDragForm::none;
    c.turbulence.closure = ClosureKind::ramp;
    const SectionOptions options;
    const SectionResult r = solve_section(c, options);
    const ColumnResult column = solve_column(c, options.cells_over_depth);
    for (std::size_t iz = 0; iz < r.z.size(); ++iz) {
        for (std::size_t iy = 0; iy < r.y.size(); ++iy) {
            EXPECT_NEAR(r.velocity[iz * r.y.size() + iy], column.profile.velocity[iz], 1e-9);
        }
    }
    EXPECT_NEAR(r.relaxation_time, column.relaxation_time, 1e-6 * column.relaxation_time);
    EXPECT_EQ(r.wall_layer_velocity, 0.0);
    // What starts uniform across stays so.
    const SectionResult later =
        advance_section(c, start_section(c, SectionStart::power_law, coarse), 1.0, coarse);
    for (std::size_t iz = 0; iz < later.z.size(); ++iz) {
        const auto row = later.velocity.begin() + static_cast<std::ptrdiff_t>(iz * later.y.size());
        const auto [low, high] = std::minmax_element(row, row + static_cast<std::ptrdiff_t>(later.y.size()));
        EXPECT_NEAR(*low, *high, 1e-10);
    }
}

/// A channel 80 mm deep whose bed and sides hold laminar water at rest.
Case laminar_channel(double width, Sides sides, double viscosity) {
    Case c;
    c.channel.dimensions = 3;
    c.channel.sides = sides;
    c.channel.width = width;
    c.channel.depth = 0.08;
    c.channel.slope = 0.001;
    c.bed.kind = BedKind::no_slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.side_walls.drag_form = SideDragForm::none;
    c.turbulence.closure = ClosureKind::none;
    c.fluid.kinematic_viscosity = viscosity;
    return c;
}

/// Laminar flow in an open channel of no-slip bed and sides, half of that in a duct twice as deep (White
/// 2006, eq. 3-48): the velocity at y from a side and z over the bed, over g S0/nu.
double rectangle_velocity(double width, double depth, double y, double z) {
    const double a = 0.5 * width;
    double sum = 0.0;
    for (int n = 1; n < 200; n += 2) {
        const double k = n * std::numbers::pi / (2.0 * a);
        // cosh(k (H - z))/cosh(k H), without overflow.
        const double ratio =
            (std::exp(-k * z) + std::exp(-k * (2.0 * depth - z))) / (1.0 + std::exp(-2.0 * k * depth));
        sum += (n % 4 == 1 ? 1.0 : -1.0) * (1.0 - ratio) * std::cos(k * (y - a)) / (n * n * n);
    }
    return 16.0 * a * a / std::pow(std::numbers::pi, 3) * sum;
}

/// Its mean over the section, and the share of the weight that the sides carry.
double rectangle_mean(double width, double depth) {
    const double a = 0.5 * width;
    double sum = 0.0;
    for (int n = 1; n < 200; n += 2) {
        sum += std::tanh(n * std::numbers::pi * depth / (2.0 * a)) / std::pow(n, 5);
    }
    return a * a / 3.0 * (1.0 - 192.0 * a / (std::pow(std::numbers::pi, 5) * depth) * sum);
}

// The walls of a no-slip channel stand at rest on its sides too, as those of the particles do; a half channel
// ends at its plane of symmetry.
TEST(Section, LaminarFlowBetweenWallsAtRestIsTheSeries) {
    for (const double width : {0.36, 0.08}) {
        for (const Sides sides : {Sides::walls, Sides::half}) {
            const Case c = laminar_channel(width, sides, 1e-3);
            const SectionResult r = solve_section(c);
            const double scale = c.streamwise_gravity() / c.fluid.kinematic_viscosity;
            const double largest = scale * rectangle_velocity(width, 0.08, 0.5 * width, 0.08);
            for (const double y : {0.1, 0.3, 0.5}) {
                for (const double z : {0.1, 0.5, 0.9}) {
                    EXPECT_NEAR(r.velocity_at(y * width, z * 0.08),
                                scale * rectangle_velocity(width, 0.08, y * width, z * 0.08), 2e-3 * largest)
                        << width << " " << y << " " << z;
                }
            }
            const double mean = scale * rectangle_mean(width, 0.08);
            EXPECT_NEAR(r.bulk_velocity / mean, 1.0, 2e-3) << width;
            EXPECT_NEAR(r.drag_share + r.side_wall_share, 1.0, 1e-10);
            // All the force on the sides is the viscous stress there.
            EXPECT_GT(r.side_wall_share, width < 0.1 ? 0.6 : 0.1);
        }
    }
}

// Laminar flow is linear, the first step of the solver exact and the residual after it rounding: whatever the
// weight that the twin of a discharge asks for, there is a solution.
TEST(Section, LaminarFlowIsFoundAtAnyWeight) {
    Case c = laminar_channel(0.36, Sides::half, 2e-5);
    for (double gravity = 0.02; gravity < 20.0; gravity *= 1.31) {
        c.fluid.gravity = gravity;
        const double mean = c.streamwise_gravity() / 2e-5 * rectangle_mean(0.36, 0.08);
        EXPECT_NEAR(solve_section(c, coarse).bulk_velocity / mean, 1.0, 5e-3) << gravity;
    }
}

TEST(Section, StressFallsToNothingAtTheSurfaceOfTheMiddle) {
    const Case c = condition_2();
    const SectionResult r = solve_section(c);
    // Far from the walls the stress is that of the water above.
    const std::size_t iy = r.y.size() - 1;
    for (std::size_t iz = 0; iz < r.z.size(); ++iz) {
        if (r.z[iz] < c.crest() + 0.5 * c.sphere_ramp()) continue;
        const double above = 1000.0 * c.streamwise_gravity() * (c.total_depth() - r.z[iz]);
        EXPECT_NEAR(r.shear_stress[iz * r.y.size() + iy], above, 0.01 * above + 1e-3) << r.z[iz];
    }
}

TEST(Section, TransientsFromEveryStartEndInTheSteadyState) {
    const Case c = condition_2();
    const SectionResult steady = solve_section(c, coarse);
    for (const SectionStart start :
         {SectionStart::column, SectionStart::uniform, SectionStart::power_law, SectionStart::rest}) {
        std::vector<SectionMoment> moments;
        const double time = 20.0 * steady.relaxation_time;
        const SectionResult end =
            advance_section(c, start_section(c, start, coarse), time, coarse,
                            [&moments](const SectionMoment& m) { moments.push_back(m); });
        EXPECT_EQ(moments.front().time, 0.0);
        EXPECT_EQ(moments.back().time, time);
        for (std::size_t i = 0; i < end.velocity.size(); ++i) {
            EXPECT_NEAR(end.velocity[i], steady.velocity[i], 1e-4 * steady.maximum_velocity);
        }
        EXPECT_NEAR(end.drag_share + end.side_wall_share, 1.0, 1e-4);
        // All along, the wall carries its part of what the bed carries.
        for (const SectionMoment& m : moments) EXPECT_GE(m.side_wall_share, 0.0);
    }
}

TEST(Section, StepsKeepTheErrorOfATransient) {
    const Case c = condition_2();
    SectionOptions fine = coarse;
    fine.tolerance = 1e-5;
    const SectionResult start = start_section(c, SectionStart::power_law, coarse);
    const SectionResult usual = advance_section(c, start, 3.0, coarse);
    const SectionResult exact = advance_section(c, start, 3.0, fine);
    EXPECT_NEAR(usual.centreline_velocity, exact.centreline_velocity, 1e-3 * exact.centreline_velocity);
    EXPECT_NEAR(usual.wall_layer_velocity, exact.wall_layer_velocity, 5e-3 * exact.wall_layer_velocity);
    // Two halves of the time are the whole.
    const SectionResult half = advance_section(c, start, 1.5, fine);
    EXPECT_NEAR(advance_section(c, half, 1.5, fine).depth_mean_velocity, exact.depth_mean_velocity,
                1e-4 * exact.depth_mean_velocity);
}

TEST(Section, SmallDeparturesFadeWithTheTimeOfTheSlowestMode) {
    const Case c = condition_2();
    SectionOptions fine = coarse;
    fine.tolerance = 1e-6;
    const SectionResult steady = solve_section(c, fine);
    SectionResult state = steady;
    for (double& u : state.velocity) u *= 1.01;
    const double time = steady.relaxation_time;
    state = advance_section(c, state, 5.0 * time, fine);
    const double before = state.wall_layer_velocity - steady.wall_layer_velocity;
    state = advance_section(c, state, time, fine);
    const double after = state.wall_layer_velocity - steady.wall_layer_velocity;
    // The middle drives the layer at the wall in nearly the same time T, so that this fades as t exp(-t/T).
    EXPECT_NEAR(std::log(before / after), 1.0 - std::log(6.0 / 5.0), 0.05);
}

TEST(Section, CalibrationMeetsTheMeasuredVelocityAtTheCentreline) {
    Case c = condition_2();
    c.bed.drag_form = DragForm::slice;
    c.measured.depth_mean_velocity = 0.35;
    const CalibrationResult r = calibrate_column(c, {.parameters = {"roughness_height"}});
    // The fit solves the section with fewer cells across; the centreline hardly sees them.
    EXPECT_NEAR(solve_section(r.conditions.front().fitted).centreline_velocity, 0.35, 1e-3 * 0.35);
    EXPECT_LT(r.conditions.front().fitted.bed.roughness_height, c.bed.roughness_height);
}

TEST(Section, VelocitiesBetweenTheCentres) {
    SectionResult r;
    r.y = {0.0, 1.0};
    r.z = {0.5, 1.5};
    r.velocity = {1.0, 2.0, 3.0, 4.0};
    EXPECT_DOUBLE_EQ(r.velocity_at(0.5, 1.0), 2.5);
    EXPECT_DOUBLE_EQ(r.velocity_at(-1.0, 0.5), 1.0);
    EXPECT_DOUBLE_EQ(r.velocity_at(9.0, 9.0), 4.0);
    // Cells from 0 to 1 and 1 to 2; above 0.5 the lower one counts half.
    const std::vector<double> means = r.depth_means(0.5, 2.0);
    EXPECT_DOUBLE_EQ(means[0], (0.5 * 1.0 + 3.0) / 1.5);
    EXPECT_DOUBLE_EQ(means[1], (0.5 * 2.0 + 4.0) / 1.5);
}

std::string message(const Case& c) {
    try {
        static_cast<void>(solve_section(c, coarse));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Section, SaysWhereThereIsNone) {
    Case c = condition_2();
    EXPECT_TRUE(has_section(c));
    c.channel.sides = Sides::periodic;
    EXPECT_FALSE(has_section(c));
    EXPECT_THAT(message(c), HasSubstr("channel.sides"));
    c = condition_2();
    c.channel.slope = 0.0;
    EXPECT_FALSE(has_section(c));
    EXPECT_THAT(message(c), HasSubstr("channel.slope"));
    c = condition_2();
    c.bed.drag_coefficient = 0.0;
    EXPECT_FALSE(has_section(c));
    EXPECT_THAT(message(c), HasSubstr("bed.drag_coefficient"));
    c = condition_2();
    c.channel.dimensions = 2;
    EXPECT_FALSE(has_section(c));
}

TEST(Section, OfTheSpsClosureHasASubstituteToStartFrom) {
    Case c = condition_2();
    c.turbulence = {};
    c.turbulence.closure = ClosureKind::sps;
    c.start.kind = StartKind::section;
    EXPECT_FALSE(has_section(c));
    EXPECT_THAT(message(c), HasSubstr("SPS"));
    const auto substitute = section_start_substitute(c);
    ASSERT_TRUE(substitute);
    EXPECT_EQ(substitute->turbulence.closure, ClosureKind::czernuszenko_rylov);
    EXPECT_GT(solve_section(*substitute).bulk_velocity, 0.2);
    c.start.kind = StartKind::uniform;
    EXPECT_FALSE(section_start_substitute(c)) << "nothing starts from a section";
    EXPECT_FALSE(section_start_substitute(condition_2())) << "it has its own";
}

}  // namespace
}  // namespace riffle::section_test
