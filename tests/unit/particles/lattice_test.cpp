#include "particles/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace riffle::lattice_test {
namespace {

Case channel(StartLattice lattice, double jitter = 0.0) {
    Case c;
    c.channel.depth = 0.056;
    c.channel.length = 0.2;
    c.numerics.spacing = 0.002;
    c.start.lattice = lattice;
    c.start.jitter = jitter;
    return c;
}

class LatticeTest : public testing::TestWithParam<StartLattice> {};

// The particles share the water: their areas add up to it, whatever the ratio of depth and spacing.
TEST_P(LatticeTest, FillsTheWater) {
    for (const double spacing : {0.002, 0.0015, 0.0019, 0.003}) {
        Case c = channel(GetParam());
        c.numerics.spacing = spacing;
        const Lattice lattice = lattice_of(c);
        EXPECT_NEAR(lattice.columns * lattice.rows * lattice.dx * lattice.dz,
                    c.channel.length * c.total_depth(), 1e-15);
        // Within the rounding to whole rows and columns the area per particle is the square of the spacing.
        EXPECT_NEAR(lattice.dx * lattice.dz / (spacing * spacing), 1.0, 0.06);
        const Particles<2> particles = lattice_particles(c);
        ASSERT_EQ(particles.size(),
                  static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows));
        const auto [low, high] =
            std::minmax_element(particles.position[1].begin(), particles.position[1].end());
        EXPECT_NEAR(*low, 0.5 * lattice.dz, 1e-15);
        EXPECT_NEAR(*high, c.total_depth() - 0.5 * lattice.dz, 1e-15);
        const auto [left, right] =
            std::minmax_element(particles.position[0].begin(), particles.position[0].end());
        EXPECT_GE(*left, 0.0);
        EXPECT_LT(*right, c.channel.length);
    }
}

INSTANTIATE_TEST_SUITE_P(Lattices, LatticeTest,
                         testing::Values(StartLattice::square, StartLattice::hexagonal));

TEST(HexagonalLattice, HasSixNeighboursAtOneDistance) {
    const Lattice lattice = lattice_of(channel(StartLattice::hexagonal));
    const double in_row = lattice.dx;
    const double across = std::hypot(0.5 * lattice.dx, lattice.dz);
    EXPECT_NEAR(lattice.x(7, 4) - lattice.x(7, 3), -0.5 * lattice.dx, 1e-15);
    EXPECT_NEAR(lattice.x(7, -1) - lattice.x(7, 0), 0.5 * lattice.dx, 1e-15);
    // Whole rows and columns leave at most 3 % between the two distances here.
    EXPECT_NEAR(across / in_row, 1.0, 0.03);
}

Case space(double spacing) {
    Case c = channel(StartLattice::body_centred);
    c.channel.dimensions = 3;
    c.channel.length = 0.1;
    c.channel.width = 0.08;
    c.numerics.spacing = spacing;
    return c;
}

TEST(BodyCentredLattice, FillsTheWater) {
    for (const double spacing : {0.004, 0.0037, 0.005}) {
        const Case c = space(spacing);
        const Lattice lattice = lattice_of(c);
        const Particles<3> particles = lattice_particles<3>(c);
        const double volume = c.channel.length * c.channel.width * c.total_depth();
        EXPECT_NEAR(static_cast<double>(particles.size()) * lattice.volume(), volume, 1e-12 * volume);
        // Within the rounding to whole rows, columns and files, which are fewer in space.
        EXPECT_NEAR(lattice.volume() / std::pow(spacing, 3), 1.0, 0.08);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax_element(particles.position[k].begin(), particles.position[k].end());
            const double extent = k == 0 ? c.channel.length : k == 1 ? c.channel.width : c.total_depth();
            // As far from the one side as from the other.
            EXPECT_GT(*low, 0.0);
            EXPECT_NEAR(*low, extent - *high, 1e-15);
        }
    }
}

// In the middle of the water: eight at sqrt(3)/2 of the cell's edge, then six at the edge.
TEST(BodyCentredLattice, HasEightNeighboursAtOneDistance) {
    Case c = space(0.005);
    const double edge = std::cbrt(2.0) * c.numerics.spacing;
    c.channel.length = 12.0 * edge;
    c.channel.width = 12.0 * edge;
    c.channel.depth = 12.0 * edge - (c.total_depth() - c.channel.depth);
    const Particles<3> p = lattice_particles<3>(c);
    const Lattice lattice = lattice_of(c);
    const std::array<double, 3> middle{lattice.x(6, 12), lattice.y(6, 12), lattice.z(12)};
    std::vector<double> distance;
    for (std::size_t i = 0; i < p.size(); ++i) {
        double squared = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            squared += (p.position[k][i] - middle[k]) * (p.position[k][i] - middle[k]);
        }
        distance.push_back(std::sqrt(squared) / edge);
    }
    std::sort(distance.begin(), distance.end());
    EXPECT_NEAR(distance[0], 0.0, 1e-12);
    for (std::size_t i = 1; i <= 8; ++i) EXPECT_NEAR(distance[i], 0.5 * std::sqrt(3.0), 1e-9);
    for (std::size_t i = 9; i <= 14; ++i) EXPECT_NEAR(distance[i], 1.0, 1e-9);
    EXPECT_GT(distance[15], 1.4);
}

TEST(LatticeParticles, JitterIsBoundedAndReproducible) {
    const Particles<2> still = lattice_particles(channel(StartLattice::square));
    const Particles<2> first = lattice_particles(channel(StartLattice::square, 0.2));
    const Particles<2> second = lattice_particles(channel(StartLattice::square, 0.2));
    Case other = channel(StartLattice::square, 0.2);
    other.start.seed = 2;
    const Particles<2> third = lattice_particles(other);
    EXPECT_EQ(first.position, second.position);
    EXPECT_NE(first.position, third.position);
    double largest = 0.0;
    for (std::size_t i = 0; i < still.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            largest = std::max(largest, std::abs(first.position[k][i] - still.position[k][i]));
        }
    }
    EXPECT_LE(largest, 0.2 * 0.002 + 1e-15);
    EXPECT_GT(largest, 0.19 * 0.002);
}

TEST(DomainOfCase, LeavesRoomForWallsAndWaves) {
    const Case c = channel(StartLattice::square);
    const Domain<2> domain = domain_of(c);
    EXPECT_TRUE(domain.periodic[0]);
    EXPECT_FALSE(domain.periodic[1]);
    EXPECT_EQ(domain.lower[0], 0.0);
    EXPECT_EQ(domain.upper[0], c.channel.length);
    EXPECT_LT(domain.lower[1], -c.numerics.wall_layers * c.numerics.spacing);
    EXPECT_GT(domain.upper[1], 1.9 * c.total_depth());
}

}  // namespace
}  // namespace riffle::lattice_test
