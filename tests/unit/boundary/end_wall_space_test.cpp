// The walls of a closed tank in three dimensions.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "boundary/wall.hpp"
#include "particles/lattice.hpp"
#include "sph/kernel.hpp"

namespace riffle::end_wall_space_test {
namespace {

Case tank() {
    Case c;
    c.channel.dimensions = 3;
    c.channel.ends = Ends::walls;
    c.channel.sides = Sides::walls;
    c.channel.wall_height = 0.05;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.channel.depth = 0.04;
    c.channel.length = 0.04;
    c.channel.width = 0.032;
    c.numerics.spacing = 0.002;
    return c;
}

/// sum V W at a place over water and walls.
double coverage(const Case& c, const Particles<3>& fluid, const WallParticles<3>& wall, const Vec<3>& x) {
    const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
    double sum = 0.0;
    const auto add = [&](const auto& position, std::size_t n) {
        for (std::size_t j = 0; j < n; ++j) {
            double squared = 0.0;
            for (std::size_t k = 0; k < 3; ++k) squared += std::pow(x[k] - position[k][j], 2);
            sum += lattice_of(c).volume() * WendlandC2<3>::value(std::sqrt(squared) / h) / (h * h * h);
        }
    };
    add(fluid.position, fluid.size());
    add(wall.position, wall.size());
    return sum;
}

TEST(ClosedTank, WallsCompleteTheSupportInEveryCorner) {
    const Case c = tank();
    const Particles<3> fluid = lattice_particles<3>(c);
    const WallParticles<3> wall = wall_particles<3>(c);
    const Lattice lattice = lattice_of(c);
    const auto at = [&](int column, int file, int row) {
        return coverage(c, fluid, wall, {lattice.x(column, row), lattice.y(file, row), lattice.z(row)});
    };
    const double middle = at(lattice.columns / 2, lattice.files / 2, lattice.rows / 2);
    EXPECT_NEAR(middle, 1.0, 0.01);
    for (const int column : {0, lattice.columns - 1}) {
        for (const int file : {0, lattice.files / 2, lattice.files - 1}) {
            for (const int row : {0, lattice.rows / 2}) {
                EXPECT_NEAR(at(column, file, row), middle, 1e-12) << column << " " << file << " " << row;
            }
        }
    }
}

// What counts of the water's motion: towards a wall, in an edge all but that along it, in a corner all.
TEST(ClosedTank, WallsLetTheWaterSlide) {
    const Case c = tank();
    const WallParticles<3> wall = wall_particles<3>(c);
    std::map<std::array<bool, 3>, int> found;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const double extent[3] = {0.04, 0.032, 1.0};
        std::array<bool, 3> beyond{};
        int walls = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = wall.position[k][i];
            beyond[k] = x < 0.0 || x > extent[k];
            walls += beyond[k] ? 1 : 0;
        }
        ASSERT_GT(walls, 0);
        ++found[beyond];
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t l = 0; l < 3; ++l) {
                EXPECT_EQ(wall.projector[3 * k + l][i], k == l && beyond[k] ? 1.0 : 0.0);
            }
            const double inward = wall.position[k][i] < 0.0 ? 1.0 : -1.0;
            EXPECT_EQ(wall.normal[k][i], walls == 1 && beyond[k] ? inward : 0.0);
        }
        EXPECT_LE(wall.position[2][i], 0.05);
    }
    // Three layers on 20 columns, 16 files and 25 rows up to the walls' height.
    EXPECT_EQ((found[{false, false, true}]), 3 * 20 * 16);
    EXPECT_EQ((found[{true, false, false}]), 2 * 3 * 16 * 25);
    EXPECT_EQ((found[{false, true, false}]), 2 * 3 * 20 * 25);
    EXPECT_EQ((found[{true, true, false}]), 4 * 9 * 25);
    EXPECT_EQ((found[{true, false, true}]), 2 * 9 * 16);
    EXPECT_EQ((found[{true, true, true}]), 4 * 27);
}

// A lid closes the tank as the bed does: complete support up to the top row, and it alone moves.
TEST(ClosedTank, HasALid) {
    Case c = tank();
    c.channel.wall_height.reset();
    c.channel.top = Top::wall;
    c.channel.lid_velocity = 0.1;
    c.bed.kind = BedKind::no_slip;
    const Particles<3> fluid = lattice_particles<3>(c);
    const WallParticles<3> wall = wall_particles<3>(c);
    const Lattice lattice = lattice_of(c);
    for (const int column : {0, lattice.columns / 2}) {
        for (const int file : {0, lattice.files / 2}) {
            for (const int row : {0, lattice.rows / 2, lattice.rows - 1}) {
                const Vec<3> place{lattice.x(column, row), lattice.y(file, row), lattice.z(row)};
                EXPECT_NEAR(coverage(c, fluid, wall, place), 1.0, 0.01)
                    << column << " " << file << " " << row;
            }
        }
    }
    int above = 0;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const Vec<3> x = vector_of(wall.position, i);
        const bool over = x[2] > 0.04;
        const bool beside = x[0] < 0.0 || x[0] > 0.04 || x[1] < 0.0 || x[1] > 0.032;
        EXPECT_EQ(wall.body[i], over && !beside ? lid_body : resting_body);
        EXPECT_EQ(wall.normal[2][i], beside ? 0.0 : over ? -1.0 : 1.0);
        above += over ? 1 : 0;
    }
    EXPECT_EQ(above, 3 * 26 * 22);
}

TEST(ClosedTank, HasTheOutlineOfTheWaterAcrossItsWidth) {
    Case c = tank();
    c.start.kind = StartKind::rest;
    c.start.water_x = {0.0, 0.02, 0.02, 0.0};
    c.start.water_z = {0.0, 0.0, 0.03, 0.03};
    const Particles<3> water = lattice_particles<3>(c);
    EXPECT_EQ(water.size(), 10U * 16U * 15U);
    const Domain<3> domain = domain_of<3>(c);
    EXPECT_FALSE(domain.periodic[0]);
    // Room for what splashes: several times the height of the water.
    EXPECT_GT(domain.upper[2], 0.05 + 5.0 * 0.03);
    c.start.water_x.clear();
    c.start.water_z.clear();
    EXPECT_LT(domain_of<3>(c).upper[2], 0.05 + 3.0 * 0.04);
}

// Staggered layers, too, look the same from either end and either side.
TEST(ClosedTank, DynamicWallsAreTheirOwnMirrorImages) {
    Case c = tank();
    c.numerics.wall = WallKind::dynamic;
    const WallParticles<3> wall = wall_particles<3>(c);
    const auto places = [&](bool mirror_x, bool mirror_y) {
        std::map<std::array<long, 3>, int> count;
        for (std::size_t i = 0; i < wall.size(); ++i) {
            const double x = mirror_x ? c.channel.length - wall.position[0][i] : wall.position[0][i];
            const double y = mirror_y ? c.channel.width - wall.position[1][i] : wall.position[1][i];
            constexpr double micrometre = 1e-6;
            ++count[{std::lround(x / micrometre), std::lround(y / micrometre),
                     std::lround(wall.position[2][i] / micrometre)}];
        }
        return count;
    };
    const auto as_built = places(false, false);
    EXPECT_EQ(as_built.size(), wall.size()) << "two particles stand at one place";
    EXPECT_EQ(places(true, false), as_built);
    EXPECT_EQ(places(false, true), as_built);
    // Behind each end as far as behind each side.
    const double reach = 0.5 * c.numerics.wall_layers * c.numerics.spacing;
    for (const std::size_t axis : {0U, 1U}) {
        const auto [least, most] =
            std::minmax_element(wall.position[axis].begin(), wall.position[axis].end());
        EXPECT_LE(*least, -reach + 1e-12);
        EXPECT_GE(*most, (axis == 0 ? c.channel.length : c.channel.width) + reach - 1e-12);
    }
}

}  // namespace
}  // namespace riffle::end_wall_space_test
