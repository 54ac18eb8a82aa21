// What upright lines and planes cut out of closed surfaces, for the drawings of a case.

#include "preview/solid_slices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/solid_shapes.hpp"

namespace riffle::solid_slices_test {
namespace {

constexpr double radius = 0.02;

SolidMesh ball() {
    return SolidMesh(closed_surface(sphere_triangles({0.1, 0.05, 0.03}, 2.0 * radius, 1e-5), "ball"));
}

double area_of(const std::vector<SheetPoint>& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const SheetPoint& a = polygon[i];
        const SheetPoint& b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(twice);
}

TEST(SolidSlices, UprightLinesKnowWhereTheyAreInside) {
    const auto inside = upright_stretches(ball(), 0.1, 0.05);
    ASSERT_EQ(inside.size(), 1U);
    EXPECT_NEAR(inside[0].low, 0.03 - radius, 2e-5);
    EXPECT_NEAR(inside[0].high, 0.03 + radius, 2e-5);
    EXPECT_TRUE(upright_stretches(ball(), 0.1 + 1.01 * radius, 0.05).empty());
    EXPECT_TRUE(upright_stretches(ball(), 0.0, 0.0).empty());
}

// The cut through the middle of a ball is a circle, from end to end, although only few lines are looked at.
TEST(SolidSlices, PlanesCutWholeShapes) {
    const SolidMesh mesh = ball();
    const auto polygons =
        slice_polygons(0.0, 0.3, 300, [&](double x) { return upright_stretches(mesh, x, 0.05); });
    ASSERT_EQ(polygons.size(), 1U);
    EXPECT_NEAR(area_of(polygons[0]), std::numbers::pi * radius * radius,
                0.01 * std::numbers::pi * radius * radius);
    EXPECT_TRUE(
        slice_polygons(0.0, 0.3, 300, [&](double x) { return upright_stretches(mesh, x, 0.08); }).empty());
}

}  // namespace
}  // namespace riffle::solid_slices_test
