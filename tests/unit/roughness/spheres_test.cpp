// The spheres at their places in three dimensions, and what the side walls take.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "roughness/bed_drag.hpp"
#include "roughness/side_wall_partition.hpp"
#include "roughness/sphere_bed.hpp"
#include "roughness/sphere_lattice.hpp"

namespace riffle::spheres_test {
namespace {

/// Flow condition 2 in three dimensions, two by two periods of the spheres.
Case bed_of(Packing packing) {
    Case c;
    c.channel.dimensions = 3;
    c.channel.slope = 0.004;
    c.channel.depth = 0.050;
    c.channel.length = 0.050;
    c.bed.packing = packing;
    c.bed.roughness_height = 0.010;
    c.bed.datum_below_crest = 0.004;
    c.channel.width = packing == Packing::hexagonal ? 2.0 * std::sqrt(3.0) * 0.025 : 0.050;
    c.bed.sphere_ramp = 0.0025;
    return c;
}

class SphereLatticeTest : public testing::TestWithParam<Packing> {};

TEST_P(SphereLatticeTest, PlanMeanIsTheMeanOfTheShapeFactor) {
    const SphereLattice lattice(bed_of(GetParam()));
    constexpr int points = 400;
    for (const double z : {0.0, 0.003, 0.0075, 0.0095, 0.0105, 0.0112}) {
        double sum = 0.0;
        for (int i = 0; i < points; ++i) {
            for (int j = 0; j < points; ++j) {
                sum += lattice.shape_factor((i + 0.5) * lattice.period_x() / points,
                                            (j + 0.5) * lattice.period_y() / points, z);
            }
        }
        // phi is continuous: 400 points over a period, 40 over the ramp.
        EXPECT_NEAR(sum / (points * points), lattice.plan_mean(z), 2e-4) << z;
    }
    EXPECT_GT(lattice.plan_mean(lattice.top() - 1e-4), 0.0);
    EXPECT_EQ(lattice.plan_mean(lattice.top() + 1e-9), 0.0);
}

TEST_P(SphereLatticeTest, RepeatsItself) {
    const SphereLattice lattice(bed_of(GetParam()));
    for (const double x : {0.0011, 0.0093, 0.0247}) {
        for (const double y : {-0.003, 0.0089, 0.0203, 0.0391}) {
            const double phi = lattice.shape_factor(x, y, 0.004);
            EXPECT_NEAR(lattice.shape_factor(x + lattice.period_x(), y, 0.004), phi, 1e-12);
            EXPECT_NEAR(lattice.shape_factor(x, y + lattice.period_y(), 0.004), phi, 1e-12);
            EXPECT_NEAR(
                lattice.shape_factor(x - 3.0 * lattice.period_x(), y - 2.0 * lattice.period_y(), 0.004), phi,
                1e-12);
        }
    }
}

// One row stands under the centreline. At the height of the centres phi is 1 in a sphere, 1/2 on its surface,
// and 1/2 + 1/2 where two touch.
TEST_P(SphereLatticeTest, HasItsSpheresAtTheirPlaces) {
    const Case c = bed_of(GetParam());
    const SphereLattice lattice(c);
    const double z = lattice.centre_height();
    EXPECT_DOUBLE_EQ(z, 0.010 - 0.0125);
    const double y = c.channel.centreline();
    const double d = lattice.period_x();
    EXPECT_NEAR(d, 0.025, 1e-9);
    EXPECT_EQ(lattice.shape_factor(0.0, y, z), 1.0);
    EXPECT_NEAR(lattice.shape_factor(0.5 * d, y, z), 1.0, 1e-12);
    EXPECT_NEAR(lattice.shape_factor(0.0, y, z + 0.0125), 0.5, 1e-12);
    // The next row: its spheres stand beside those of the first, or between them.
    const bool hexagonal = GetParam() == Packing::hexagonal;
    const double next = hexagonal ? 0.5 * lattice.period_y() : lattice.period_y();
    EXPECT_EQ(lattice.shape_factor(hexagonal ? 0.5 * d : 0.0, y + next, z), 1.0);
    EXPECT_NEAR(lattice.spheres_per_area(),
                hexagonal ? hexagonal_spheres_per_area(0.025) : square_spheres_per_area(0.025),
                1e-6 * lattice.spheres_per_area());
}

INSTANTIATE_TEST_SUITE_P(, SphereLatticeTest, testing::Values(Packing::hexagonal, Packing::square),
                         [](const auto& chosen) {
                             return chosen.param == Packing::hexagonal ? "hexagonal" : "square";
                         });

// With a sharp surface the slices of the spheres carry the drag of the two-dimensional form.
TEST(SphereDrag, SliceFormHasThePlanMeanOfTheConsistentFormIn2D) {
    Case space = bed_of(Packing::hexagonal);
    space.bed.sphere_ramp = 1e-7;
    space.bed.drag_form = DragForm::slice;
    Case plane = space;
    plane.channel.dimensions = 2;
    plane.bed.drag_form = DragForm::consistent;
    const auto slice = make_bed_drag(space);
    const auto consistent = make_bed_drag(plane);
    for (double z = 0.0; z < 0.0099; z += 0.0007) {
        EXPECT_NEAR(slice->coefficient(z), consistent->coefficient(z), 1e-4 * consistent->coefficient(z))
            << z;
    }
}

// 1/2 C_d times the frontal area of the spheres, whatever the length over which the drag sets in.
TEST(SphereDrag, VolumeFormCarriesTheWholeSphere) {
    for (const double ramp : {1e-6, 0.0025, 0.005}) {
        Case c = bed_of(Packing::hexagonal);
        c.bed.roughness_height = 0.030;  // the whole sphere in the water, and some below it
        c.bed.sphere_ramp = ramp;
        const auto drag = make_bed_drag(c);
        constexpr int slices = 20000;
        const double dz = drag->top() / slices;
        double sum = 0.0;
        for (int i = 0; i < slices; ++i) sum += drag->coefficient((i + 0.5) * dz) * dz;
        const double frontal = 0.25 * 3.14159265358979 * 0.025 * 0.025;
        const double exact = 0.5 * c.bed.drag_coefficient * frontal * SphereLattice(c).spheres_per_area();
        // The ramp, symmetric about the surface, adds (ramp/D)^2 to the volume.
        EXPECT_NEAR(sum / exact, 1.0 + std::pow(ramp / 0.025, 2), 1e-3);
    }
}

TEST(SphereDrag, ActsWhereTheSpheresStand) {
    for (const DragForm form : {DragForm::consistent, DragForm::slice, DragForm::thesis}) {
        Case c = bed_of(Packing::hexagonal);
        c.bed.drag_form = form;
        const auto drag = make_bed_drag(c);
        ASSERT_TRUE(drag->varies_in_plan());
        double sum = 0.0;
        constexpr int points = 200;
        const SphereLattice lattice(c);
        for (int i = 0; i < points; ++i) {
            for (int j = 0; j < points; ++j) {
                sum += drag->coefficient_at(i * lattice.period_x() / points, j * lattice.period_y() / points,
                                            0.004);
            }
        }
        EXPECT_NEAR(sum / (points * points), drag->coefficient(0.004), 2e-3 * drag->coefficient(0.004));
        EXPECT_EQ(drag->coefficient_at(0.0, c.channel.centreline(), drag->top() + 1e-9), 0.0);
        EXPECT_EQ(drag->coefficient_at(0.0, c.channel.centreline(), -1e-9), 0.0);
    }
}

// Table of model.md, section 5: conditions 1, 2, 5, 8 with the roughness heights of the thesis in 3D.
TEST(SideWallPartition, HasTheRatiosOfTheThesisConditions) {
    struct Row {
        double depth, roughness, k, wall_stress;
    };
    for (const Row& row : {Row{0.040, 0.008, 1.209, 0.605}, Row{0.050, 0.008, 1.198, 0.599},
                           Row{0.070, 0.006, 1.177, 0.589}, Row{0.100, 0.006, 1.143, 0.571}}) {
        const double depth = row.depth + row.roughness - 0.004;
        const SideWallPartition p = side_wall_partition(depth, 0.459, 0.03);
        EXPECT_NEAR(p.k, row.k, 6e-4);
        EXPECT_NEAR(p.wall_stress / (0.03 * depth), row.wall_stress, 6e-4);
    }
}

TEST(SideWallPartition, CarriesTheWholeWeight) {
    for (const double width : {0.01, 0.1, 0.112, 0.459, 3.0, 1000.0}) {
        const double depth = 0.056;
        const SideWallPartition p = side_wall_partition(depth, width, 0.04);
        if (width >= 2.0 * depth) {
            EXPECT_NEAR(p.k * p.k * p.k + 2.0 * depth / width * p.k, 2.0, 1e-12);
        }
        EXPECT_NEAR(p.bed_stress * width + 2.0 * p.wall_stress * depth, 0.04 * depth * width,
                    1e-12 * depth * width);
        EXPECT_NEAR(p.bed_area + 2.0 * p.wall_area, depth * width, 1e-12 * width);
        EXPECT_NEAR(p.bed_share, p.bed_stress / (0.04 * depth), 1e-12);
        // u_*bed/u_*wall = k, so the force on a wall over that on the bed is H/(k^2 W).
        EXPECT_NEAR(p.wall_over_bed, depth / (p.k * p.k * width), 1e-12);
    }
    // In a channel narrower than two depths the lines of both corners meet below the surface; the water under
    // them is the bed's. There is no jump at the width where they meet in it.
    const SideWallPartition narrow = side_wall_partition(0.056, 0.056, 0.04);
    double under_lines = 0.0;
    constexpr int parts = 10000;
    for (int i = 0; i < parts; ++i) {
        const double y = (i + 0.5) / parts * 0.056;
        under_lines += std::min(0.056, std::min(y, 0.056 - y) / narrow.k) * 0.056 / parts;
    }
    EXPECT_NEAR(narrow.bed_area, under_lines, 1e-6 * under_lines);
    EXPECT_NEAR(narrow.k * narrow.k, narrow.bed_stress / narrow.wall_stress, 1e-12);
    EXPECT_NEAR(side_wall_partition(0.056, 0.112 - 1e-9, 0.04).bed_share,
                side_wall_partition(0.056, 0.112 + 1e-9, 0.04).bed_share, 1e-7);
    // A wide channel has no walls.
    EXPECT_NEAR(side_wall_partition(0.056, 1e6, 0.04).bed_share, 1.0, 1e-6);
}

TEST(SphereLattice, CentresLieWhereTheSpheresAre) {
    Case c;
    c.channel.dimensions = 3;
    c.channel.slope = 0.004;
    c.channel.length = 0.05;
    c.channel.width = 0.0866;
    c.bed.roughness_height = 0.010;
    const SphereLattice lattice(c);
    const auto centres = lattice.centres(c.channel.length, c.channel.width);
    double within = 0.0;
    for (const auto& centre : centres) {
        EXPECT_EQ(centre[2], lattice.centre_height());
        EXPECT_DOUBLE_EQ(lattice.shape_factor(centre[0], centre[1], centre[2]), 1.0);
        // Beyond its radius along the row the next one begins.
        EXPECT_NEAR(lattice.shape_factor(centre[0], centre[1], centre[2] + 0.51 * c.bed.sphere_diameter), 0.4,
                    1e-9);
        within += centre[1] >= 0.0 && centre[1] < c.channel.width * (1.0 - 1e-9) ? 1.0 : 0.0;
    }
    EXPECT_NEAR(within, lattice.spheres_per_area() * c.channel.length * c.channel.width, 0.5);
}

}  // namespace
}  // namespace riffle::spheres_test
