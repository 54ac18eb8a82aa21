// A bed of several roughnesses: what holds the water back over each of them.

#include "case/bed_patch.hpp"

#include <gtest/gtest.h>

#include "plane_bed.hpp"
#include "roughness/covered_bed.hpp"
#include "roughness/particle_bed_drag.hpp"

namespace riffle::bed_patch_test {
namespace {

constexpr double row = 0.01;

Case sand() {
    Case c;
    c.channel.slope = 0.002;
    c.channel.depth = 0.2;
    c.channel.length = 2.0;
    test::lay_plane_bed(c, 0.001);
    c.turbulence.closure = ClosureKind::nezu_rodi;
    c.numerics.spacing = row;
    return c;
}

BedPatch gravel(double from, double to) {
    BedPatch patch;
    patch.name = "gravel";
    patch.equivalent_roughness = 0.02;
    patch.x_from = from;
    patch.x_to = to;
    return patch;
}

BedPatch spheres(double from, double to) {
    BedPatch patch = gravel(from, to);
    patch.kind = BedKind::spheres;
    patch.equivalent_roughness.reset();
    patch.sphere_diameter = 0.06;
    patch.roughness_height = 0.04;
    return patch;
}

TEST(BedPatch, HasTheDragOfItsOwnBed) {
    Case c = sand();
    c.bed_patches = {gravel(0.5, 1.0), spheres(1.2, 1.6)};
    const auto drag = make_particle_bed_drag(c, row);
    const auto of_sand = make_particle_bed_drag(sand(), row);
    const auto of_gravel = make_particle_bed_drag(with_bed_of(c, c.bed_patches[0]), row);
    const auto of_spheres = make_particle_bed_drag(with_bed_of(c, c.bed_patches[1]), row);
    for (const double z : {0.0, 0.004, 0.016, 0.03, 0.06}) {
        EXPECT_EQ(drag->coefficient_at(0.3, 0.0, z), of_sand->coefficient(z));
        EXPECT_NEAR(drag->coefficient_at(0.7, 0.0, z), of_gravel->coefficient(z), 1e-11);
        EXPECT_NEAR(drag->coefficient_at(1.4, 0.0, z), of_spheres->coefficient(z), 1e-11);
        // A particle on an edge has half of both.
        EXPECT_NEAR(drag->coefficient_at(1.0, 0.0, z),
                    0.5 * (of_sand->coefficient(z) + of_gravel->coefficient(z)), 1e-12);
    }
    EXPECT_GT(of_gravel->coefficient(0.005), 2.0 * of_sand->coefficient(0.005));
    EXPECT_EQ(drag->top(), of_spheres->top());
}

TEST(BedPatch, FollowsTheSpeedAsItsOwnBedDoes) {
    Case c = sand();
    c.bed_patches = {gravel(0.5, 1.0), spheres(1.2, 1.6)};
    c.bed_patches[0].kind = BedKind::smooth;
    c.bed_patches[0].equivalent_roughness.reset();
    const auto drag = make_particle_bed_drag(c, row);
    const auto smooth = make_particle_bed_drag(with_bed_of(c, c.bed_patches[0]), row);
    ASSERT_TRUE(drag->varies_with_speed());
    EXPECT_NEAR(drag->speed_factor_at(0.7, 0.0, 0.005, 0.05), smooth->speed_factor(0.005, 0.05), 1e-11);
    EXPECT_GT(drag->speed_factor_at(0.7, 0.0, 0.005, 0.05), 1.1);
    EXPECT_NEAR(drag->speed_factor_at(1.4, 0.0, 0.005, 0.05), 1.0, 1e-11);  // of the drag of spheres
}

TEST(BedPatch, LiesAcrossTheEndsOfAPeriodicChannel) {
    Case c = sand();
    c.bed_patches = {gravel(0.0, 0.5)};
    const auto drag = make_particle_bed_drag(c, row);
    const auto of_sand = make_particle_bed_drag(sand(), row);
    const auto of_gravel = make_particle_bed_drag(with_bed_of(c, c.bed_patches[0]), row);
    const double both = 0.5 * (of_sand->coefficient(0.0) + of_gravel->coefficient(0.0));
    EXPECT_NEAR(drag->coefficient_at(0.0, 0.0, 0.0), both, 1e-12);
    EXPECT_NEAR(drag->coefficient_at(2.0, 0.0, 0.0), both, 1e-12);
}

TEST(BedPatch, KeepsTheDepthOverTheBedLevel) {
    // Crests of a patch over a plane bed, and a plane patch among spheres.
    Case plane = sand();
    plane.bed_patches = {spheres(0.5, 1.0)};
    const Case over_spheres = with_bed_of(plane, plane.bed_patches[0]);
    EXPECT_DOUBLE_EQ(over_spheres.total_depth(), plane.total_depth());
    EXPECT_DOUBLE_EQ(over_spheres.crest(), 0.04);
    Case rough = sand();
    rough.bed.kind = BedKind::spheres;
    rough.bed.equivalent_roughness.reset();
    rough.bed.roughness_height = 0.01;
    rough.bed.datum_below_crest = 0.004;
    rough.bed_patches = {gravel(0.5, 1.0)};
    const Case over_plane = with_bed_of(rough, rough.bed_patches[0]);
    EXPECT_DOUBLE_EQ(over_plane.total_depth(), rough.total_depth());
    EXPECT_EQ(over_plane.crest(), 0.0);
}

TEST(BedPatch, AtAnEndIsTheBedOfTheTwinThere) {
    Case c = sand();
    c.bed_patches = {gravel(1.0, 2.0)};
    EXPECT_EQ(with_bed_at(c, 0.0).bed.equivalent_roughness, 0.001);
    EXPECT_EQ(with_bed_at(c, 2.0).bed.equivalent_roughness, 0.02);
    EXPECT_TRUE(with_bed_at(c, 2.0).bed_patches.empty());
    EXPECT_EQ(patch_beside(c, 2.0), nullptr);
    c.channel.dimensions = 3;
    c.channel.width = 1.0;
    c.bed_patches[0].y_to = 0.4;
    EXPECT_EQ(with_bed_at(c, 2.0).bed.equivalent_roughness, 0.001);
    ASSERT_NE(patch_beside(c, 2.0), nullptr);
    EXPECT_EQ(patch_beside(c, 2.0)->name, "gravel");
}

// Water over a sill does not meet the bed below it; beside the sill, and under a deck, it does. One higher
// than the drag reaches changes nothing, and the drag is the same object.
TEST(BedPatch, SolidsCoverTheBed) {
    Case c = sand();
    Solid sill;
    sill.name = "sill";
    sill.x = {0.5, 1.0, 1.0, 0.5};
    sill.z = {0.0, 0.0, 0.02, 0.02};
    Solid deck = sill;
    deck.name = "deck";
    deck.x = {1.5, 1.8, 1.8, 1.5};
    deck.z = {0.15, 0.15, 0.18, 0.18};
    c.solids = {sill, deck};
    const auto open = make_particle_bed_drag(sand(), row);
    const auto drag = drag_beside_solids(c, make_particle_bed_drag(c, row));
    for (const double z : {0.022, 0.03}) {
        EXPECT_EQ(drag->coefficient_at(0.7, 0.0, z), 0.0);
        EXPECT_EQ(drag->coefficient_at(0.495, 0.0, z), open->coefficient(z));
        EXPECT_EQ(drag->coefficient_at(1.6, 0.0, z), open->coefficient(z));
    }
    EXPECT_GT(open->coefficient(0.022), 0.0);
    c.solids.front().z = {0.0, 0.0, 0.1, 0.1};
    EXPECT_FALSE(drag_beside_solids(c, make_particle_bed_drag(c, row))->varies_in_plan());
}

}  // namespace
}  // namespace riffle::bed_patch_test
