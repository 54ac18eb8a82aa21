// What the shapes of solids hold.

#include "case/solid_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/solid_shapes.hpp"

namespace riffle {
namespace {

Case in_dimensions(int dimensions) {
    Case c;
    c.channel.dimensions = dimensions;
    c.numerics.spacing = 0.01;
    return c;
}

TEST(SolidVolume, OfATriangleInThePlane) {
    Solid solid;
    solid.x = {3.0, 1.0, 1.0};  // with the clock: the sense does not matter
    solid.z = {2.0, 2.0, 5.0};
    std::swap(solid.x[1], solid.x[2]);
    std::swap(solid.z[1], solid.z[2]);
    const SolidVolume v = solid_volume(in_dimensions(2), solid);
    EXPECT_NEAR(v.volume, 3.0, 1e-12);
    EXPECT_NEAR(v.centroid[0], 5.0 / 3.0, 1e-12);
    EXPECT_NEAR(v.centroid[2], 3.0, 1e-12);
    // A right triangle with legs b along x and h along z: b h/36 (b^2, h^2, -b h/2 with this corner).
    EXPECT_NEAR(v.spread[0], 2.0 * 3.0 / 36.0 * 4.0, 1e-12);
    EXPECT_NEAR(v.spread[8], 2.0 * 3.0 / 36.0 * 9.0, 1e-12);
    EXPECT_NEAR(v.spread[2], -2.0 * 3.0 / 36.0 * 3.0, 1e-12);
    EXPECT_NEAR(v.inertia()[4], v.spread[0] + v.spread[8], 1e-12);
    Case c = in_dimensions(2);
    EXPECT_NEAR(moment_point(c, solid)[2], 3.0, 1e-12);
    solid.moment_about = {0.5, 0.25};
    EXPECT_EQ(moment_point(c, solid), (std::array<double, 3>{0.5, 0.0, 0.25}));
}

TEST(SolidVolume, OfABoxAndASphereInSpace) {
    Solid box;
    box.shape = SolidShape::box;
    box.centre = {1.0, 2.0, 3.0};
    box.size = {0.2, 0.4, 0.6};
    const SolidVolume v = solid_volume(in_dimensions(3), box);
    EXPECT_NEAR(v.volume, 0.048, 1e-12);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(v.centroid[k], box.centre[k], 1e-12);
        EXPECT_NEAR(v.spread[4 * k], 0.048 * box.size[k] * box.size[k] / 12.0, 1e-12);
    }
    EXPECT_NEAR(v.spread[1], 0.0, 1e-12);
    EXPECT_NEAR(v.inertia()[0], 0.048 * (0.16 + 0.36) / 12.0, 1e-12);
    Solid sphere;
    sphere.shape = SolidShape::sphere;
    sphere.centre = {0.0, 0.0, 1.0};
    sphere.diameter = 0.5;
    const SolidVolume s = solid_volume(in_dimensions(3), sphere);
    const double volume = std::numbers::pi / 6.0 * 0.125;
    EXPECT_NEAR(s.volume, volume, 1e-9 * volume);
    // Facets are within a hundredth of the spacing of the sphere.
    EXPECT_NEAR(s.inertia()[4], 0.1 * volume * 0.25, 0.005 * volume * 0.025);
}

}  // namespace
}  // namespace riffle
