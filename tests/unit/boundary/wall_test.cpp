#include "boundary/wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "particles/lattice.hpp"
#include "sph/kernel.hpp"

namespace riffle::wall_test {
namespace {

struct Shape {
    StartLattice lattice = StartLattice::square;
    Ends ends = Ends::periodic;
    Top top = Top::free_surface;
};

Case channel(const Shape& shape) {
    Case c;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.channel.depth = 0.05;
    c.channel.length = 0.06;
    c.channel.ends = shape.ends;
    c.channel.top = shape.top;
    c.numerics.spacing = 0.002;
    c.numerics.smoothing_ratio = 1.5;
    c.numerics.wall_layers = 3;
    c.start.lattice = shape.lattice;
    return c;
}

/// sum V W at a point over fluid and walls, nearest images along a periodic x.
double coverage(const Case& c, const Particles<2>& fluid, const WallParticles<2>& wall, double x, double z) {
    const Lattice lattice = lattice_of(c);
    const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
    const auto term = [&](double xj, double zj, double volume) {
        double dx = x - xj;
        if (c.channel.ends == Ends::periodic) dx -= c.channel.length * std::nearbyint(dx / c.channel.length);
        return volume * WendlandC2<2>::value(std::hypot(dx, z - zj) / h) / (h * h);
    };
    double sum = 0.0;
    for (std::size_t j = 0; j < fluid.size(); ++j) {
        sum += term(fluid.position[0][j], fluid.position[1][j], lattice.dx * lattice.dz);
    }
    for (std::size_t j = 0; j < wall.size(); ++j) {
        sum += term(wall.position[0][j], wall.position[1][j], wall.volume[j]);
    }
    return sum;
}

class WallTest : public testing::TestWithParam<Shape> {};

// To the kernel the walls are the continuation of the water: a particle beside a bed, a lid, an end wall or
// in a corner sees the sum of W that a particle in the middle sees.
TEST_P(WallTest, CompletesTheSupport) {
    const Case c = channel(GetParam());
    const Particles<2> fluid = lattice_particles(c);
    const WallParticles<2> wall = wall_particles(c);
    const Lattice lattice = lattice_of(c);
    const double middle = coverage(c, fluid, wall, lattice.x(lattice.columns / 2, lattice.rows / 2),
                                   lattice.z(lattice.rows / 2));
    EXPECT_NEAR(middle, 1.0, 0.01);
    const double support = 2.0 * c.numerics.smoothing_ratio * c.numerics.spacing;
    int checked = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i) {
        if (c.channel.top == Top::free_surface && fluid.position[1][i] > c.total_depth() - support) continue;
        EXPECT_NEAR(coverage(c, fluid, wall, fluid.position[0][i], fluid.position[1][i]), middle, 1e-12);
        ++checked;
    }
    EXPECT_GT(checked, 500);
}

TEST_P(WallTest, HasNormalsProjectorsAndDepths) {
    const Case c = channel(GetParam());
    const WallParticles<2> wall = wall_particles(c);
    const double area = c.channel.length * c.total_depth();
    ASSERT_GT(wall.size(), 0U);
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const double x = wall.position[0][i];
        const double z = wall.position[1][i];
        const double nx = wall.normal[0][i];
        const double nz = wall.normal[1][i];
        // Behind a surface of the water, by its depth along the normal, or in a corner.
        const bool inside_x = x > 0.0 && x < c.channel.length;
        const bool inside_z = z > 0.0 && (z < c.total_depth() || c.channel.top == Top::free_surface);
        EXPECT_FALSE(inside_x && inside_z);
        const bool corner = nx == 0.0 && nz == 0.0;
        EXPECT_EQ(corner, !inside_x && !inside_z);
        const double trace = wall.projector[0][i] + wall.projector[3][i];
        EXPECT_DOUBLE_EQ(trace, corner ? 2.0 : 1.0);
        EXPECT_EQ(wall.projector[1][i], wall.projector[2][i]);
        if (!corner) {
            EXPECT_DOUBLE_EQ(std::hypot(nx, nz), 1.0);
            const double surface_x = x + nx * wall.depth[i];
            const double surface_z = z + nz * wall.depth[i];
            const double distance =
                nx != 0.0 ? std::min(std::abs(surface_x), std::abs(surface_x - c.channel.length))
                          : std::min(std::abs(surface_z), std::abs(surface_z - c.total_depth()));
            EXPECT_NEAR(distance, 0.0, 1e-15);
        }
        EXPECT_GT(wall.depth[i], 0.0);
        EXPECT_LT(wall.volume[i], 0.01 * area);
    }
}

std::string name_of(const testing::TestParamInfo<Shape>& info) {
    return std::string(info.param.lattice == StartLattice::square ? "square" : "hexagonal") +
           (info.param.ends == Ends::periodic ? "_periodic" : "_closed") +
           (info.param.top == Top::wall ? "_lid" : "_surface");
}

INSTANTIATE_TEST_SUITE_P(Shapes, WallTest,
                         testing::Values(Shape{}, Shape{.ends = Ends::walls}, Shape{.top = Top::wall},
                                         Shape{.ends = Ends::walls, .top = Top::wall},
                                         Shape{.lattice = StartLattice::hexagonal},
                                         Shape{.lattice = StartLattice::hexagonal, .ends = Ends::walls}),
                         name_of);

TEST(WallParticlesOfCase, AreNoneInAFullyPeriodicBox) {
    EXPECT_EQ(wall_particles(channel({.top = Top::periodic})).size(), 0U);
}

// Dynamic particles (Dalrymple & Knio): layers half a spacing apart, every other one shifted by half a
// spacing.
TEST(WallParticlesOfCase, DynamicLayersAreStaggered) {
    Case c = channel({});
    c.numerics.wall = WallKind::dynamic;
    c.numerics.wall_layers = 2;
    const WallParticles<2> wall = wall_particles(c);
    std::set<long> heights;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const long layer = std::lround(-wall.position[1][i] / 0.001);
        heights.insert(layer);
        const double columns = wall.position[0][i] / 0.002;
        const double offset = columns - std::floor(columns);
        EXPECT_NEAR(offset, layer == 1 ? 0.5 : 0.0, 1e-9) << "layer " << layer;
    }
    EXPECT_EQ(heights, (std::set<long>{1, 2}));
}

TEST(WallLawOfCase, FollowsBedAndWall) {
    Case c = channel({});
    EXPECT_FALSE(wall_action(c).no_slip);
    EXPECT_FALSE(wall_action(c).dynamic);
    c.bed.kind = BedKind::no_slip;
    EXPECT_TRUE(wall_action(c).no_slip);
    c.bed.kind = BedKind::spheres;
    EXPECT_FALSE(wall_action(c).no_slip);
    c.numerics.wall = WallKind::dynamic;
    EXPECT_TRUE(wall_action(c).dynamic);
    EXPECT_TRUE(wall_action(c).no_slip);
}

TEST(WallParticlesOfCase, PermuteMovesAllQuantitiesTogether) {
    const WallParticles<2> before = wall_particles(channel({.ends = Ends::walls}));
    WallParticles<2> after = before;
    std::vector<std::int32_t> order(before.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(order.size() - 1 - i);
    after.permute(order);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto j = static_cast<std::size_t>(order[i]);
        EXPECT_EQ(after.position[0][i], before.position[0][j]);
        EXPECT_EQ(after.position[1][i], before.position[1][j]);
        EXPECT_EQ(after.volume[i], before.volume[j]);
        EXPECT_EQ(after.depth[i], before.depth[j]);
        EXPECT_EQ(after.normal[0][i], before.normal[0][j]);
        EXPECT_EQ(after.projector[0][i], before.projector[0][j]);
        EXPECT_EQ(after.projector[3][i], before.projector[3][j]);
    }
}

}  // namespace
}  // namespace riffle::wall_test
