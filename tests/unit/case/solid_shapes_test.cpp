// Solids by their shape: that they enclose what the shape does, and that the facets are fine enough.

#include "case/solid_shapes.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "case/bed_surface.hpp"
#include "case/end_floor.hpp"
#include "case/solid_mesh.hpp"
#include "changed_cases.hpp"

namespace riffle::solid_shapes_test {
namespace {

Case space() {
    Case c = test::with_mesh();
    c.solids.clear();
    c.numerics.spacing = 0.002;
    return c;
}

Solid shape(SolidShape kind) {
    Solid solid;
    solid.name = "s";
    solid.shape = kind;
    solid.centre = {0.1, 0.05, 0.02};
    solid.size = {0.04, 0.02, 0.03};
    solid.diameter = 0.03;
    solid.length = 0.05;
    return solid;
}

TEST(SolidShapes, EncloseTheirVolume) {
    const Case c = space();
    const double r = 0.015;
    EXPECT_NEAR(SolidMesh(c, shape(SolidShape::box)).volume(), 0.04 * 0.02 * 0.03, 1e-15);
    EXPECT_NEAR(SolidMesh(c, shape(SolidShape::sphere)).volume(), 4.0 / 3.0 * std::numbers::pi * r * r * r,
                1e-12);
    for (const SolidAxis axis : {SolidAxis::x, SolidAxis::y, SolidAxis::z}) {
        Solid cylinder = shape(SolidShape::cylinder);
        cylinder.axis = axis;
        const SolidMesh mesh(c, cylinder);
        EXPECT_NEAR(mesh.volume(), std::numbers::pi * r * r * 0.05, 1e-12);
        const auto along = static_cast<std::size_t>(axis);
        EXPECT_NEAR(mesh.upper()[along] - cylinder.centre[along], 0.025, 1e-12);
    }
}

TEST(SolidShapes, FacetsAreFarFinerThanTheSpacing) {
    const Case c = space();
    for (const double diameter : {0.01, 0.05, 0.3}) {
        Solid ball = shape(SolidShape::sphere);
        ball.diameter = diameter;
        Solid pier = shape(SolidShape::cylinder);
        pier.diameter = diameter;
        const auto off = [&](const Triangles& triangles, std::size_t axes) {
            double most = 0.0;
            for (const Triangle& t : triangles) {
                double squares = 0.0;
                for (std::size_t k = 0; k < axes; ++k) {
                    const double middle = (t[0][k] + t[1][k] + t[2][k]) / 3.0 - ball.centre[k];
                    squares += middle * middle;
                }
                if (squares > 0.2 * diameter * diameter) {
                    most = std::max(most, std::abs(std::sqrt(squares) - 0.5 * diameter));
                }
            }
            return most;
        };
        EXPECT_LT(off(shape_triangles(c, ball), 3), 1.5 * facet_error(c)) << diameter;
        EXPECT_LT(off(shape_triangles(c, pier), 2), 1.5 * facet_error(c)) << diameter;
    }
}

TEST(SolidShapes, BoxesAndRectanglesTurnAgainstTheClock) {
    const Case c = space();
    Solid box = shape(SolidShape::box);
    box.angle = 90.0;
    const SolidMesh mesh(c, box);
    EXPECT_DOUBLE_EQ(mesh.upper()[0], 0.11);
    EXPECT_DOUBLE_EQ(mesh.upper()[1], 0.07);
    box.angle = 30.0;
    EXPECT_TRUE(
        SolidMesh(c, box).contains({0.1 + 0.018 * std::cos(0.5236), 0.05 + 0.018 * std::sin(0.5236), 0.02}));
    Solid plate;
    plate.shape = SolidShape::rectangle;
    plate.centre = {0.1, 0.02};
    plate.size = {0.04, 0.01};
    plate.angle = 30.0;
    const Outline outline = shape_outline(c, plate);
    EXPECT_TRUE(contains(outline, 0.1 + 0.018 * std::cos(0.5236), 0.02 + 0.018 * std::sin(0.5236)));
    EXPECT_NEAR(signed_area(outline), 4e-4, 1e-15);
}

TEST(SolidShapes, ACircleHasItsArea) {
    const Case c = space();
    Solid pipe;
    pipe.shape = SolidShape::circle;
    pipe.centre = {0.1, 0.02};
    pipe.diameter = 0.03;
    EXPECT_NEAR(signed_area(shape_outline(c, pipe)), std::numbers::pi * 0.015 * 0.015, 1e-12);
}

TEST(SolidShapes, ASectionIsABodyUnderTheChannel) {
    const Case c = space();
    Solid bed = shape(SolidShape::section);
    bed.y = {0.0, 0.04, 0.04, 0.1};
    bed.levels = {0.02, 0.02, 0.005, 0.005};
    const SolidMesh mesh(c, bed);
    EXPECT_TRUE(mesh.contains({0.1, 0.03, 0.019}));
    EXPECT_FALSE(mesh.contains({0.1, 0.05, 0.019}));
    EXPECT_TRUE(mesh.contains({0.1, 0.05, 0.004}));
    EXPECT_LT(mesh.lower()[0], 0.0);
    EXPECT_GT(mesh.upper()[0], c.channel.length);
}

TEST(SolidShapes, SpheresRepeatWithThePeriodicChannelAndDoNotOverlap) {
    Case c = space();
    c.channel.length = 0.1;
    c.channel.width = 0.02 * std::sqrt(3.0) * 2.0;
    c.channel.sides = Sides::periodic;
    Solid layer;
    layer.name = "s";
    layer.shape = SolidShape::spheres;
    layer.diameter = 0.02;
    for (const SolidPacking packing : {SolidPacking::hexagonal, SolidPacking::square, SolidPacking::random}) {
        layer.packing = packing;
        std::vector<Point3> centres;
        for (const LaidSphere& sphere : laid_spheres(c, layer)) centres.push_back(sphere.centre);
        double inside = 0.0;
        for (std::size_t i = 0; i < centres.size(); ++i) {
            const auto& [x, y, z] = centres[i];
            EXPECT_EQ(z, 0.01);
            inside += x >= 0.0 && x < c.channel.length && y >= 0.0 && y < c.channel.width ? 1.0 : 0.0;
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_GT(std::hypot(x - centres[j][0], y - centres[j][1]),
                          packing == SolidPacking::square ? 0.0173 : 0.02 - 1e-9);
            }
        }
        const double share = inside * std::numbers::pi * 1e-4 / (c.channel.length * c.channel.width);
        if (packing == SolidPacking::hexagonal) {
            EXPECT_NEAR(share, std::numbers::pi / std::sqrt(12.0), 1e-9);
        }
        if (packing == SolidPacking::random) {
            EXPECT_NEAR(share, 0.547, 0.06);
        }
    }
}

TEST(SolidShapes, SpheresOfSeveralSizesCoverTheirSharesAndDoNotOverlap) {
    Case c = space();
    c.channel.length = 0.3;
    c.channel.width = 0.2;
    c.channel.sides = Sides::periodic;
    Solid layer;
    layer.name = "s";
    layer.shape = SolidShape::spheres;
    layer.diameter = 0.02;
    layer.packing = SolidPacking::random;
    layer.smaller_diameters = {0.012, 0.006};
    layer.area_shares = {0.2, 0.15};
    const auto spheres = laid_spheres(c, layer);
    std::map<double, double> covered;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const auto& [centre, d] = spheres[i];
        EXPECT_EQ(centre[2], 0.5 * d);
        const bool inside = centre[0] >= 0.0 && centre[0] < c.channel.length && centre[1] >= 0.0 &&
                            centre[1] < c.channel.width;
        covered[d] += inside ? 0.25 * std::numbers::pi * d * d / (c.channel.length * c.channel.width) : 0.0;
        for (std::size_t j = 0; j < i; ++j) {
            const Point3 way{centre[0] - spheres[j].centre[0], centre[1] - spheres[j].centre[1],
                             centre[2] - spheres[j].centre[2]};
            EXPECT_GT(std::hypot(way[0], way[1], way[2]), 0.5 * (d + spheres[j].diameter) * (1.0 - 1e-9));
        }
    }
    ASSERT_EQ(covered.size(), 3U);
    EXPECT_NEAR(covered[0.02], 0.2, 0.006);  // one sphere is half a percent of the plan
    EXPECT_NEAR(covered[0.012], 0.15, 0.002);
    EXPECT_GT(covered[0.006], 0.1);  // in all denser than spheres of one size
    EXPECT_GT(covered[0.02] + covered[0.012] + covered[0.006], 0.547);
}

// The fill of a bed that goes through a periodic channel is even, across its ends too.
TEST(SolidShapes, ABedPassesThroughPeriodicEnds) {
    Case c = test::flume();
    Solid bed;
    bed.x = {-0.05, 0.25, 0.25, -0.05};
    bed.z = {-0.02, -0.02, 0.01, 0.01};
    EXPECT_TRUE(passes_through(c, bed));
    bed.z = {-0.02, -0.02, 0.02, 0.01};
    EXPECT_FALSE(passes_through(c, bed));
    bed.z = {-0.02, -0.02, 0.01, 0.01};
    bed.x = {-0.001, 0.25, 0.25, -0.001};
    EXPECT_FALSE(passes_through(c, bed));
    c.channel.ends = Ends::walls;
    bed.x = {-0.05, 0.25, 0.25, -0.05};
    EXPECT_FALSE(passes_through(c, bed));
}

}  // namespace
}  // namespace riffle::solid_shapes_test
