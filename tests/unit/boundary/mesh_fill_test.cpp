// Wall particles that fill a solid in three dimensions up to its true surface.

#include "boundary/mesh_fill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "boundary/wall.hpp"
#include "boundary/wall_motion.hpp"
#include "case/solid_mesh.hpp"
#include "periodic_reach.hpp"

namespace riffle::mesh_fill_test {
namespace {

/// A reach with a solid that its layers fill throughout.
Case channel_with(Solid solid) {
    Case c = test::periodic_reach();
    c.numerics.wall_layers = 20;
    c.start.packed = true;
    solid.name = "solid";
    c.solids = {std::move(solid)};
    return c;
}

Solid turned_box() {
    Solid s;
    s.shape = SolidShape::box;
    s.centre = {0.0303, 0.0297, 0.0181};
    s.size = {0.017, 0.023, 0.0155};
    s.angle = 30.0;
    return s;
}

struct Moments {
    double volume = 0.0;
    Vec<3> centroid{};
    double square = 0.0;  ///< mean of the squared distance from the centroid, m2
};

Moments moments_of(const WallParticles<3>& walls) {
    Moments m;
    for (std::size_t i = 0; i < walls.size(); ++i) m.volume += is_solid(walls, i) ? walls.volume[i] : 0.0;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (std::size_t k = 0; k < 3 && is_solid(walls, i); ++k) {
            m.centroid[k] += walls.volume[i] * walls.position[k][i] / m.volume;
        }
    }
    for (std::size_t i = 0; i < walls.size(); ++i) {
        for (std::size_t k = 0; k < 3 && is_solid(walls, i); ++k) {
            const double d = walls.position[k][i] - m.centroid[k];
            m.square += walls.volume[i] * d * d / m.volume;
        }
    }
    return m;
}

TEST(ShareBelowPlane, IsThatOfPlanesAlongTheFaces) {
    const Vec<3> size{1.0, 2.0, 4.0};
    EXPECT_EQ(share_below_plane(size, {1.0, 0.0, 0.0}, 0.5), 1.0);
    EXPECT_EQ(share_below_plane(size, {1.0, 0.0, 0.0}, -0.5), 0.0);
    EXPECT_NEAR(share_below_plane(size, {0.0, -1.0, 0.0}, 0.3), 0.65, 1e-3);
    EXPECT_NEAR(share_below_plane(size, {0.0, 0.0, 1.0}, -1.0), 0.25, 1e-3);
}

// Halves, a corner whose pyramid is known, and the plane seen from the other side.
TEST(ShareBelowPlane, IsThatOfInclinedPlanes) {
    const Vec<3> cube{1.0, 1.0, 1.0};
    const double third = 1.0 / std::sqrt(3.0);
    EXPECT_NEAR(share_below_plane(cube, {third, third, third}, 0.0), 0.5, 1e-12);
    // x + y + z < 1 of coordinates from a corner.
    EXPECT_NEAR(share_below_plane(cube, {third, third, third}, -0.5 * third), 1.0 / 6.0, 1e-12);
    const Vec<3> n{0.6, -0.64, 0.48};
    const Vec<3> brick{0.3, 1.7, 0.9};
    for (const double d : {-0.4, -0.1, 0.05, 0.3, 0.6}) {
        EXPECT_NEAR(share_below_plane(brick, n, d) + share_below_plane(brick, {-n[0], -n[1], -n[2]}, -d), 1.0,
                    1e-12);
        // Against a sum over small boxes.
        constexpr int parts = 60;
        double below = 0.0;
        for (int i = 0; i < parts * parts * parts; ++i) {
            const std::array<int, 3> at{i % parts, i / parts % parts, i / (parts * parts)};
            double height = 0.0;
            for (std::size_t k = 0; k < 3; ++k) height += n[k] * brick[k] * ((at[k] + 0.5) / parts - 0.5);
            below += height < d ? 1.0 : 0.0;
        }
        EXPECT_NEAR(share_below_plane(brick, n, d), below / (parts * parts * parts), 2e-3) << d;
    }
}

// Volume, centroid and radius of gyration of a sphere; of its triangles, which hold a little less. Planes
// that touch a round surface lie outside of it: by 4e-4 of the volume here, less than a particle.
TEST(MeshFill, HasTheMomentsOfASphere) {
    const Case c = channel_with(test::sphere_in_reach());
    const Moments m = moments_of(wall_particles<3>(c));
    EXPECT_NEAR(m.volume, meshes_of(c)->front().volume(), 1e-3 * m.volume);
    EXPECT_NEAR(m.volume, std::numbers::pi / 6.0 * std::pow(0.024, 3), 5e-3 * m.volume);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(m.centroid[k], c.solids.front().centre[k], 1e-5);
    // Points in the middles of cells miss the spread within them: dx^2 / 4.
    EXPECT_NEAR(m.square + 1e-6, 0.6 * 0.012 * 0.012, 0.01 * m.square);
}

Solid upright_box(const char* name, const Point3& centre, const Point3& size) {
    Solid s;
    s.name = name;
    s.shape = SolidShape::box;
    s.centre = {centre[0], centre[1], centre[2]};
    s.size = {size[0], size[1], size[2]};
    return s;
}

// Boxes that overlap, their tops in one plane that cuts the cells: the volume is that of their union, and of
// two that only touch the sum of both.
TEST(MeshFill, FillsSolidsThatOverlapOnce) {
    Case c = channel_with(upright_box("a", {0.0253, 0.0297, 0.0181}, {0.017, 0.0162, 0.0155}));
    c.solids.push_back(upright_box("b", {0.0333, 0.0297, 0.0206}, {0.017, 0.0102, 0.0105}));
    const double overlap = 0.009 * 0.0102 * 0.0105;
    const double first = 0.017 * 0.0162 * 0.0155;
    const double second = 0.017 * 0.0102 * 0.0105;
    for (const bool turned : {false, true}) {
        if (turned) std::swap(c.solids[0], c.solids[1]);
        EXPECT_NEAR(moments_of(wall_particles<3>(c)).volume, first + second - overlap, 4e-3 * first);
    }
    c.solids = {upright_box("a", {0.0253, 0.0297, 0.0181}, {0.0173, 0.0162, 0.0155}),
                upright_box("b", {0.0426, 0.0297, 0.0181}, {0.0173, 0.0162, 0.0155})};
    EXPECT_NEAR(moments_of(wall_particles<3>(c)).volume, 2.0 * 0.0173 * 0.0162 * 0.0155, 4e-3 * first);
    c.solids[1].centre = c.solids[0].centre;
    EXPECT_NEAR(moments_of(wall_particles<3>(c)).volume, 0.0173 * 0.0162 * 0.0155, 4e-3 * first);
}

// Faces that cut the cells at an angle, edges and corners.
TEST(MeshFill, HasTheMomentsOfATurnedBox) {
    const Case c = channel_with(turned_box());
    const Moments m = moments_of(wall_particles<3>(c));
    const auto& size = c.solids.front().size;
    EXPECT_NEAR(m.volume, size[0] * size[1] * size[2], 2e-3 * m.volume);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(m.centroid[k], c.solids.front().centre[k], 1e-5);
}

// On the places of the lattice the same sphere and box are off by whole particles.
TEST(MeshFill, IsNearerToTheSolidThanTheLattice) {
    for (const Solid& solid : {test::sphere_in_reach(), turned_box()}) {
        Case c = channel_with(solid);
        const double exact = meshes_of(c)->front().volume();
        const double cut = std::abs(moments_of(wall_particles<3>(c)).volume - exact);
        c.start.packed = false;
        const double whole = std::abs(moments_of(wall_particles<3>(c)).volume - exact);
        EXPECT_LT(cut, 0.3 * whole);
    }
}

// A box between the faces of the cells has its wall particles on the places of the lattice.
TEST(MeshFill, OfABoxBetweenTheCellsIsTheLattice) {
    Solid box = turned_box();
    box.centre = {0.03, 0.03, 0.02};
    box.size = {0.02, 0.012, 0.008};
    box.angle = 0.0;
    Case c = channel_with(box);
    const WallParticles<3> cut = wall_particles<3>(c);
    c.start.packed = false;
    const WallParticles<3> whole = wall_particles<3>(c);
    ASSERT_EQ(cut.size(), whole.size());
    for (std::size_t i = 0; i < cut.size(); ++i) {
        EXPECT_NEAR(cut.volume[i], whole.volume[i], 1e-15);
        EXPECT_NEAR(cut.depth[i], whole.depth[i], 1e-12);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(cut.position[k][i], whole.position[k][i], 1e-12);
    }
}

TEST(MeshFill, KnowsNormalAndDepthOfEachParticle) {
    const Case c = channel_with(test::sphere_in_reach());
    const WallParticles<3> walls = wall_particles<3>(c);
    const auto& centre = c.solids.front().centre;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (!is_solid(walls, i)) continue;
        double radius = 0.0;
        for (std::size_t k = 0; k < 3; ++k) radius += std::pow(walls.position[k][i] - centre[k], 2);
        radius = std::sqrt(radius);
        EXPECT_NEAR(walls.depth[i], 0.012 - radius, 1e-4);
        for (std::size_t k = 0; k < 3 && radius > 0.004; ++k) {
            EXPECT_NEAR(walls.normal[k][i], (walls.position[k][i] - centre[k]) / radius, 0.2);
        }
    }
}

// A solid that moves has the same particles as one at rest.
TEST(MeshFill, IsTheSameOfASolidThatMoves) {
    Case c = channel_with(turned_box());
    const Moments at_rest = moments_of(wall_particles<3>(c));
    c.solids.front().motion = SolidMotion::constant;
    c.solids.front().velocity_x = 0.1;
    const Moments moving = moments_of(wall_particles<3>(c));
    EXPECT_NEAR(moving.volume, at_rest.volume, 1e-12 * at_rest.volume);
    EXPECT_NEAR(moving.square, at_rest.square, 1e-9 * at_rest.square);
}

}  // namespace
}  // namespace riffle::mesh_fill_test
