// Outlines of patches in plan: what lies in them, and in two of them.

#include "case/plan_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/bed_patch.hpp"
#include "case/patch_range.hpp"
#include "changed_cases.hpp"

namespace riffle {
namespace {

const Outline triangle{{0.0, 4.0, 0.0}, {0.0, 0.0, 2.0}};

/// A letter U, open towards larger y.
const Outline letter{{0.0, 3.0, 3.0, 2.0, 2.0, 1.0, 1.0, 0.0}, {0.0, 0.0, 2.0, 2.0, 1.0, 1.0, 2.0, 2.0}};

Outline circle(double x, double y, double radius, int corners) {
    Outline outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        outline.x.push_back(x + radius * std::cos(angle));
        outline.z.push_back(y + radius * std::sin(angle));
    }
    return outline;
}

TEST(PlanOutline, HasChordsAlongBothAxes) {
    const auto along = chords(triangle, 0, 0.5);
    ASSERT_EQ(along.size(), 1U);
    EXPECT_NEAR(along[0].from, 0.0, 1e-15);
    EXPECT_NEAR(along[0].to, 3.0, 1e-15);
    const auto across = chords(triangle, 1, 1.0);
    ASSERT_EQ(across.size(), 1U);
    EXPECT_NEAR(across[0].to, 1.5, 1e-15);
    EXPECT_TRUE(chords(triangle, 0, 2.5).empty());
    // Both arms of the letter.
    const auto arms = chords(letter, 0, 1.5);
    ASSERT_EQ(arms.size(), 2U);
    EXPECT_EQ(arms[0].to, 1.0);
    EXPECT_EQ(arms[1].from, 2.0);
}

TEST(PlanOutline, SharesAreasWithOthers) {
    EXPECT_NEAR(common_area(triangle, triangle), 4.0, 1e-12);
    EXPECT_NEAR(common_area(letter, rectangle_in_plan({0.0, 3.0}, {1.0, 2.0})), 2.0, 1e-12);
    // The triangle below the letter's middle: 1 < x < 2, y < 1 of its hypotenuse y = 2 - x/2 is whole.
    EXPECT_NEAR(common_area(triangle, rectangle_in_plan({1.0, 2.0}, {0.0, 1.0})), 1.0, 1e-12);
    EXPECT_NEAR(common_area(triangle, rectangle_in_plan({3.0, 4.0}, {0.0, 1.0})), 0.25, 1e-12);
    // Neighbours with an edge in common, in either sense of rotation, and one within another.
    EXPECT_NEAR(common_area(triangle, {{4.0, 4.0, 0.0}, {0.0, 2.0, 2.0}}), 0.0, 1e-12);
    EXPECT_NEAR(common_area(triangle, {{4.0, 0.0, 4.0}, {0.0, 2.0, 2.0}}), 0.0, 1e-12);
    const Outline within = circle(1.0, 0.6, 0.3, 24);
    EXPECT_NEAR(common_area(triangle, within), std::abs(signed_area(within)), 1e-12);
    EXPECT_EQ(common_area(triangle, circle(9.0, 9.0, 1.0, 12)), 0.0);
    // What two circles have in common: the lens of their segments.
    const double lens = 2.0 * std::acos(0.5) - 0.5 * std::sqrt(3.0);
    EXPECT_NEAR(common_area(circle(0.0, 0.0, 1.0, 720), circle(1.0, 0.0, 1.0, 720)), lens, 1e-4);
}

TEST(PlanOutline, HasTheSameAreaInARectangleEitherWay) {
    const Outline round = circle(0.3, 0.2, 0.17, 33);
    for (const Outline& outline : {triangle, letter, round}) {
        for (double x = -0.5; x < 4.0; x += 0.37) {
            for (double y = -0.5; y < 2.5; y += 0.29) {
                const PatchRange along{x, x + 0.6};
                const PatchRange across{y, y + 0.41};
                EXPECT_NEAR(area_in_rectangle(outline, along, across),
                            common_area(outline, rectangle_in_plan(along, across)), 1e-12);
            }
        }
    }
}

BedPatch wedge() {
    BedPatch patch;
    patch.name = "wedge";
    patch.equivalent_roughness = 0.01;
    patch.x = {0.01, 0.04, 0.01};
    patch.y = {0.0, 0.0, 0.03};
    return patch;
}

TEST(PlanOutline, IsWhereAPatchLies) {
    Case c = test::with_bed_patches();
    c.bed_patches = {wedge()};
    const BedPatch& patch = c.bed_patches.front();
    EXPECT_FALSE(covers_length(c, patch));
    EXPECT_FALSE(covers_width(c, patch));
    EXPECT_EQ(ranges_of(c, patch)[1].to, 0.03);
    BedPatch beside = patch;
    beside.x = {0.04, 0.04, 0.01};
    beside.y = {0.0, 0.03, 0.03};
    EXPECT_FALSE(lie_over_each_other(c, patch, beside));
    beside.x[0] = 0.039;
    EXPECT_TRUE(lie_over_each_other(c, patch, beside));
    // Their ranges meet, they do not: a rectangle in the far corner.
    BedPatch corner;
    corner.x_from = 0.03;
    corner.x_to = 0.04;
    corner.y_from = 0.02;
    corner.y_to = 0.03;
    EXPECT_FALSE(lie_over_each_other(c, patch, corner));
}

// The uniform flow at an open end is that over what the outline covers there.
TEST(PlanOutline, IsAStripAtAPlaceAlongTheChannel) {
    Case c = test::with_bed_patches();
    c.bed_patches = {wedge()};
    const Case there = with_bed_at(c, 0.02);
    ASSERT_EQ(there.bed_patches.size(), 1U);
    EXPECT_NEAR(*there.bed_patches[0].y_to, 0.02, 1e-12);
    EXPECT_NEAR(*there.bed_patches[0].y_from, 0.0, 1e-12);
    EXPECT_TRUE(covers_length(there, there.bed_patches[0]));
    EXPECT_TRUE(with_bed_at(c, 0.045).bed_patches.empty());
}

// As a rectangle there: the bed of the patch alone, for which the twins of a plane bed hold.
TEST(PlanOutline, IsTheBedWhereItCoversTheWidth) {
    Case c = test::with_bed_patches();
    const double width = c.channel.simulated_width();
    BedPatch patch = wedge();
    patch.x = {0.0, 0.02, 0.04, 0.0};
    patch.y = {0.0, 0.0, width, width};
    c.bed_patches = {patch};
    EXPECT_EQ(with_bed_at(c, 0.0).bed_patches.size(), 0U);
    EXPECT_EQ(with_bed_at(c, 0.0).bed.equivalent_roughness, patch.equivalent_roughness);
    EXPECT_EQ(with_bed_at(c, 0.03).bed_patches.size(), 1U);
    EXPECT_EQ(patch_beside(c, 0.0), nullptr);
    EXPECT_NE(patch_beside(c, 0.03), nullptr);
    // And the whole plan is the whole channel.
    patch.x = {0.0, c.channel.length, c.channel.length, 0.0};
    patch.y = {0.0, 0.0, width, width};
    EXPECT_TRUE(covers_length(c, patch));
    EXPECT_TRUE(covers_width(c, patch));
}

TEST(PlanOutline, IsAsThinAsItsWidthAcross) {
    // A band of 10 mm at 45 degrees, 100 mm long.
    const double far = 0.1 / std::numbers::sqrt2;
    const double beside = 0.01 / std::numbers::sqrt2;
    const Outline band{{0.0, far, far - beside, -beside}, {0.0, far, far + beside, beside}};
    EXPECT_NEAR(least_width(band), 0.01, 1e-12);
    EXPECT_NEAR(usual_thickness(band), 0.01, 1e-12);
    const Outline rectangle{{0.0, 0.03, 0.03, 0.0}, {0.0, 0.0, 0.02, 0.02}};
    EXPECT_NEAR(least_width(rectangle), 0.02, 1e-12);
    EXPECT_NEAR(usual_thickness(rectangle), 0.02, 1e-12);
    // An L of two arms of 10 mm is as thin as they are; an island with sharp ends is as thick as in its
    // middle.
    EXPECT_NEAR(usual_thickness({{0.0, 0.1, 0.1, 0.01, 0.01, 0.0}, {0.0, 0.0, 0.01, 0.01, 0.1, 0.1}}), 0.01,
                1e-12);
    Outline island;
    for (int k = 0; k < 40; ++k) {
        const double angle = std::numbers::pi * k / 20.0;
        island.x.push_back(0.1 * std::cos(angle));
        island.z.push_back(0.03 * std::sin(angle));
    }
    EXPECT_GT(usual_thickness(island), 0.05);
}

}  // namespace
}  // namespace riffle
