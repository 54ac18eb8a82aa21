// The walls of a channel in three dimensions.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boundary/wall.hpp"
#include "particles/lattice.hpp"
#include "sph/kernel.hpp"

namespace riffle::side_wall_test {
namespace {

Case channel(Sides sides, StartLattice arrangement = StartLattice::square) {
    Case c;
    c.channel.dimensions = 3;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.channel.depth = 0.04;
    c.channel.length = 0.02;
    c.channel.width = 0.032;
    c.channel.sides = sides;
    c.numerics.spacing = 0.002;
    c.start.lattice = arrangement;
    return c;
}

/// sum V W at a point over fluid and walls, nearest images on periodic axes.
double coverage(const Case& c, const Particles<3>& fluid, const WallParticles<3>& wall, const Vec<3>& x) {
    const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
    const double volume = lattice_of(c).volume();
    const auto term = [&](const auto& position, std::size_t j) {
        double squared = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            double d = x[k] - position[k][j];
            if (k == 0) {
                d -= c.channel.length * std::nearbyint(d / c.channel.length);
            } else if (k == 1 && c.channel.sides == Sides::periodic) {
                d -= c.channel.width * std::nearbyint(d / c.channel.width);
            }
            squared += d * d;
        }
        return volume * WendlandC2<3>::value(std::sqrt(squared) / h) / (h * h * h);
    };
    double sum = 0.0;
    for (std::size_t j = 0; j < fluid.size(); ++j) sum += term(fluid.position, j);
    for (std::size_t j = 0; j < wall.size(); ++j) sum += term(wall.position, j);
    return sum;
}

/// That to the kernel the walls are the continuation of the water, beside the bed, a side wall, a plane of
/// symmetry and in the edge between them.
void expect_complete_support(const Case& c) {
    const Particles<3> fluid = lattice_particles<3>(c);
    const WallParticles<3> wall = wall_particles<3>(c);
    const Lattice lattice = lattice_of(c);
    const auto at = [&](int file, int row) {
        return coverage(c, fluid, wall, {lattice.x(3, row), lattice.y(file, row), lattice.z(row)});
    };
    const double middle = at(lattice.files / 2, lattice.rows / 2);
    EXPECT_NEAR(middle, 1.0, 0.01);
    for (const int file : {0, 1, lattice.files / 2, lattice.files - 1}) {
        for (const int row : {0, 1, 2, lattice.rows / 2}) {
            EXPECT_NEAR(at(file, row), middle, 1e-12) << file << " " << row;
        }
    }
}

class SideWallTest : public testing::TestWithParam<Sides> {};

TEST_P(SideWallTest, CompletesTheSupport) { expect_complete_support(channel(GetParam())); }

// Half of the cell's rows stand in the shifted half, on the walls too.
TEST(BodyCentredWalls, CompleteTheSupport) {
    expect_complete_support(channel(Sides::walls, StartLattice::body_centred));
}

// What counts of the water's velocity in the continuity equation: the part towards the wall; in the edge all
// but the part along the channel, where sliding must cost nothing.
TEST_P(SideWallTest, LetsTheWaterSlideAlongTheChannel) {
    const Case c = channel(GetParam());
    const WallParticles<3> wall = wall_particles<3>(c);
    const double width = c.channel.simulated_width();
    std::array<int, 3> found{};  // bed, sides, edges
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const double y = wall.position[1][i];
        const double z = wall.position[2][i];
        const bool below = z < 0.0;
        const bool beside = y < 0.0 || y > width;
        ASSERT_TRUE(below || beside);
        ++found[below && beside ? 2 : beside ? 1 : 0];
        for (std::size_t k = 0; k < 9; ++k) {
            const bool across = k == 4 && beside;
            const bool up = k == 8 && below;
            EXPECT_EQ(wall.projector[k][i], across || up ? 1.0 : 0.0);
        }
        const double depth = below ? -z : y < 0.0 ? -y : y - width;
        EXPECT_NEAR(wall.depth[i], depth, 1e-15);
        if (!(below && beside)) {
            EXPECT_EQ(wall.normal[1][i], below ? 0.0 : y < 0.0 ? 1.0 : -1.0);
            EXPECT_EQ(wall.normal[2][i], below ? 1.0 : 0.0);
        }
    }
    EXPECT_GT(found[0], 0);
    if (GetParam() == Sides::periodic) {
        EXPECT_EQ(found[1] + found[2], 0);
    } else {
        // Three layers of ten columns behind both sides.
        const Lattice lattice = lattice_of(c);
        EXPECT_EQ(found[2], 2 * 3 * 3 * lattice.columns);
        EXPECT_EQ(found[1], 2 * 3 * lattice.columns * (lattice.rows + lattice.rows / 2));
    }
}

INSTANTIATE_TEST_SUITE_P(, SideWallTest, testing::Values(Sides::periodic, Sides::walls, Sides::half),
                         [](const auto& chosen) {
                             return chosen.param == Sides::periodic ? "periodic"
                                    : chosen.param == Sides::walls  ? "walls"
                                                                    : "half";
                         });

TEST(SideWall, DynamicLayersStandHalfASpacingApartAndStaggered) {
    Case c = channel(Sides::walls);
    c.numerics.wall = WallKind::dynamic;
    c.numerics.wall_layers = 2;
    const WallParticles<3> wall = wall_particles<3>(c);
    const double half = 0.5 * c.numerics.spacing;
    std::size_t below = 0;
    std::size_t beside = 0;
    for (std::size_t j = 0; j < wall.size(); ++j) {
        const double y = wall.position[1][j];
        const double z = wall.position[2][j];
        const double outside = z > 0.0 ? std::max(-y, y - c.channel.width) : -z;
        // A half and a whole spacing behind the wall, no particle on the water's side.
        EXPECT_NEAR(std::abs(outside / half - 1.5), 0.5, 1e-9) << y << ' ' << z;
        if (z < 0.0 && y > 0.0 && y < c.channel.width) ++below;
        if (z > 0.0 && y < 0.0) ++beside;
        const double x = wall.position[0][j] / half;
        EXPECT_NEAR(x - std::floor(x + 0.5), 0.0, 1e-9) << "on the lattice or between two of its places";
    }
    // Two layers with a particle for each of the water's columns and files.
    const double columns = c.channel.length / c.numerics.spacing;
    EXPECT_NEAR(static_cast<double>(below), 2.0 * columns * c.channel.width / c.numerics.spacing,
                columns + 0.5);
    EXPECT_GT(beside, 2.0 * columns * c.channel.depth / c.numerics.spacing);
    // Seen from the middle of the channel nothing is different from side to side.
    double moment = 0.0;
    for (const double y : wall.position[1]) moment += y - 0.5 * c.channel.width;
    EXPECT_NEAR(moment / static_cast<double>(wall.size()), 0.0, 0.01 * c.channel.width);
}

TEST(SideWall, DomainAndLatticeCoverTheSimulatedWidth) {
    Case c = channel(Sides::half);
    EXPECT_EQ(lattice_of(c).files, 8);
    EXPECT_DOUBLE_EQ(lattice_of(c).y(7, 0), 0.015);
    EXPECT_FALSE(domain_of<3>(c).periodic[1]);
    EXPECT_LT(domain_of<3>(c).lower[1], -0.006);
    EXPECT_GT(domain_of<3>(c).upper[1], 0.022);
    c.channel.sides = Sides::walls;
    EXPECT_EQ(lattice_of(c).files, 16);
    c.channel.sides = Sides::periodic;
    EXPECT_TRUE(domain_of<3>(c).periodic[1]);
    EXPECT_EQ(domain_of<3>(c).upper[1], 0.032);
}

}  // namespace
}  // namespace riffle::side_wall_test
