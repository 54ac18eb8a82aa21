// The part of a solid's surface that water can touch, in small pieces.

#include "boundary/surface_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "periodic_reach.hpp"

namespace riffle::surface_pieces_test {
namespace {

Case reach_with(std::vector<Solid> solids) {
    Case c = test::periodic_reach();
    for (Solid& solid : solids) {
        solid.name = "solid";
        c.solids.push_back(std::move(solid));
    }
    return c;
}

Solid box(double bottom) {
    Solid s;
    s.shape = SolidShape::box;
    s.centre = {0.03, 0.03, bottom + 0.01};
    s.size = {0.02, 0.016, 0.02};
    return s;
}

struct Sums {
    double area = 0.0;
    double volume = 0.0;
    Vec<3> along{};  ///< sum of the pieces' areas times their normals, m2
};

Sums sums_of(const Case& c, std::size_t solid, double size) {
    Sums sums;
    for (const SurfacePiece& piece : surface_pieces(c, solid, size)) {
        const double area = std::hypot(piece.area[0], piece.area[1], piece.area[2]);
        sums.area += area;
        EXPECT_LE(area, size * size);
        for (std::size_t k = 0; k < 3; ++k) {
            sums.along[k] += piece.area[k];
            sums.volume += piece.place[k] * piece.area[k] / 3.0;
        }
    }
    return sums;
}

TEST(SurfacePieces, OfASphereInTheWaterAreAllOfIt) {
    const Sums sums = sums_of(reach_with({test::sphere_in_reach()}), 0, 0.001);
    // Of the polyhedron that stands for the sphere.
    EXPECT_NEAR(sums.area, std::numbers::pi * 0.024 * 0.024, 0.01 * std::numbers::pi * 0.024 * 0.024);
    EXPECT_NEAR(sums.volume, std::numbers::pi / 6.0 * std::pow(0.024, 3), 0.01 * std::pow(0.024, 3));
    for (const double along : sums.along) EXPECT_NEAR(along, 0.0, 1e-9);
}

TEST(SurfacePieces, OfABoxOnTheBedAreWithoutItsBottom) {
    const Sums sums = sums_of(reach_with({box(0.0)}), 0, 0.001);
    EXPECT_NEAR(sums.along[2], 0.02 * 0.016, 1e-9);
    EXPECT_NEAR(sums.area, 0.02 * 0.016 + 2.0 * (0.02 + 0.016) * 0.02, 1e-9);
}

TEST(SurfacePieces, AreNotWhereTwoSolidsTouch) {
    // One box on the other: what is left of the lower one is its sides.
    const Case c = reach_with({box(0.0), box(0.02)});
    EXPECT_NEAR(sums_of(c, 0, 0.001).along[2], 0.0, 1e-9);
    EXPECT_NEAR(sums_of(c, 1, 0.001).along[2], 0.02 * 0.016, 1e-9);
}

// A bed that goes on beyond the ends of its channel counts within it: along a periodic one nothing presses
// it, whatever overhangs, and upward as much as the channel is long. Faces level with the bed lie on it.
TEST(SurfacePieces, OfABedThatOverhangsAreThoseOfTheChannel) {
    for (const Ends ends : {Ends::periodic, Ends::open}) {
        Case c;
        c.channel.length = 0.4;
        c.channel.depth = 0.1;
        c.channel.ends = ends;
        c.bed.kind = BedKind::slip;
        Solid bed;
        bed.name = "bed";
        bed.x = {-0.05, 0.45, 0.45, 0.35, 0.2, 0.05, -0.05};
        bed.z = {-0.01, -0.01, 0.01, 0.01, 0.03, 0.01, 0.01};
        c.solids = {bed};
        Vec<3> along{};
        for (const SurfacePiece& piece : surface_pieces(c, 0, 0.005)) {
            for (std::size_t k = 0; k < 3; ++k) along[k] += piece.area[k];
        }
        EXPECT_NEAR(along[0], 0.0, 1e-12);
        EXPECT_NEAR(along[2], 0.4, 1e-12);
        for (double& z : c.solids[0].z) z = std::max(0.0, z) == 0.01 ? 0.0 : z;
        Vec<3> level{};
        for (const SurfacePiece& piece : surface_pieces(c, 0, 0.005)) {
            for (std::size_t k = 0; k < 3; ++k) level[k] += piece.area[k];
        }
        EXPECT_NEAR(level[2], 0.3, 1e-12);  // the hill alone
    }
}

TEST(SurfacePieces, OfAnOutlineInTheCornerOfATankAreItsSlope) {
    Case c;
    c.channel.length = 0.4;
    c.channel.depth = 0.1;
    c.channel.ends = Ends::walls;
    c.bed.kind = BedKind::slip;
    Solid beach;
    beach.name = "beach";
    beach.x = {0.2, 0.4, 0.4};
    beach.z = {0.0, 0.2, 0.0};
    c.solids = {beach};
    Vec<3> along{};
    for (const SurfacePiece& piece : surface_pieces(c, 0, 0.005)) {
        for (std::size_t k = 0; k < 3; ++k) along[k] += piece.area[k];
    }
    EXPECT_NEAR(along[0], -0.2, 1e-12);
    EXPECT_NEAR(along[2], 0.2, 1e-12);
}

}  // namespace
}  // namespace riffle::surface_pieces_test
