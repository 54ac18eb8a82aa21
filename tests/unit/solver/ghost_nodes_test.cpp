#include "walls/ghost_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "boundary/wall.hpp"
#include "particles/lattice.hpp"
#include "smooth_tank.hpp"

namespace riffle::ghost_nodes_test {
namespace {

constexpr double column_width = 0.005;

Case tank(Top top) {
    Case c = test::smooth_tank(0.04, 0.05);
    c.channel.top = top;
    c.numerics.wall = WallKind::modified_dynamic;
    c.start.kind = StartKind::rest;
    c.start.jitter = 0.2;
    return c;
}

/// Disordered water with linear density and velocity, and the ghost nodes of its walls.
struct Tank {
    Case parameters;
    WallParticles<2> walls;
    std::unique_ptr<GhostNodes<2>> ghosts;

    static double density(double x, double z) { return 0.004 + 0.05 * x - 0.1 * z; }
    static double velocity(double x, double z) { return 0.3 - 2.0 * x + 5.0 * z; }

    explicit Tank(Top top, bool uniform = false) : parameters(tank(top)), walls(wall_particles(parameters)) {
        const Case& c = parameters;
        const Domain<2> domain = domain_of<2>(c);
        const FixedPoint<2> fixed_point(domain);
        const Scheme scheme = make_scheme(c, nullptr);
        Particles<2> water = lattice_particles<2>(c);
        water.permute(spatial_order<2>(domain, position_view<2>(water.position), column_width, 0.001));
        const Clusters<2> clusters =
            build_clusters<2>(domain, fixed_point, position_view<2>(water.position), column_width);
        PairData<2, double> data;
        data.motion.resize(clusters.slots() + 1);
        for (std::size_t slot = 0; slot < clusters.slots(); ++slot) {
            const std::int32_t particle = clusters.particle_of(slot);
            data.motion[slot].x = {clusters.slot_position[0][slot], clusters.slot_position[1][slot]};
            if (particle >= 0) {
                const auto i = static_cast<std::size_t>(particle);
                const double x = water.position[0][i];
                const double z = water.position[1][i];
                water.density_deviation[i] = uniform ? 0.004 : density(x, z);
                data.motion[slot].u = {uniform ? 0.3 : velocity(x, z), 0.1};
                data.motion[slot].volume = 4e-6;
            }
        }
        ghosts = std::make_unique<GhostNodes<2>>(c, scheme, domain, walls, column_width);
        ghosts->build_list(clusters, 2.2 * scheme.smoothing_length);
        ghosts->interpolate(data, clusters, water.density_deviation);
    }
};

TEST(GhostNodes, StandAtTheMirrorImagesInTheWater) {
    const Tank tank(Top::wall);
    const double length = tank.parameters.channel.length;
    const double depth = tank.parameters.total_depth();
    for (std::size_t i = 0; i < tank.walls.size(); ++i) {
        const Vec<2> node = tank.ghosts->node(i);
        const double x = tank.walls.position[0][i];
        const double z = tank.walls.position[1][i];
        EXPECT_GT(std::min(node[0], node[1]), 0.0);
        EXPECT_LT(node[0], length);
        EXPECT_LT(node[1], depth);
        // The middle between both is on a wall, or in a corner.
        const double middle_x = 0.5 * (x + node[0]);
        const double middle_z = 0.5 * (z + node[1]);
        EXPECT_TRUE(std::abs(middle_x * (middle_x - length)) < 1e-11 ||
                    std::abs(middle_z * (middle_z - depth)) < 1e-11);
        if (tank.walls.normal[0][i] != 0.0) {
            EXPECT_NEAR(node[1], z, 1e-10);
        }
    }
}

// Exact for linear fields in disordered water, one-sided at the walls: the density at the wall particle, the
// velocity at the node.
TEST(GhostNodes, FindLinearFields) {
    const Tank tank(Top::wall);
    for (std::size_t i = 0; i < tank.walls.size(); ++i) {
        const GhostValue<2>& value = tank.ghosts->of(i);
        const Vec<2> node = tank.ghosts->node(i);
        ASSERT_TRUE(value.found);
        EXPECT_NEAR(value.deviation, Tank::density(tank.walls.position[0][i], tank.walls.position[1][i]),
                    1e-9);
        EXPECT_NEAR(value.velocity[0], Tank::velocity(node[0], node[1]), 1e-7);
        EXPECT_NEAR(value.velocity[1], 0.1, 1e-9);
    }
}

// Above a free surface there is too little water for the matrix and then none. What is said there is the
// mean, carried on as water at rest: less than at the surface.
TEST(GhostNodes, FallBackAboveTheSurface) {
    const Tank tank(Top::free_surface, true);
    const double depth = tank.parameters.total_depth();
    const double h = tank.parameters.numerics.smoothing_ratio * tank.parameters.numerics.spacing;
    int without_water = 0;
    int above = 0;
    for (std::size_t i = 0; i < tank.walls.size(); ++i) {
        const GhostValue<2>& value = tank.ghosts->of(i);
        const double z = tank.walls.position[1][i];
        if (z > depth + 2.0 * h) {
            EXPECT_FALSE(value.found);
            ++without_water;
        } else if (z < depth - 0.002) {
            EXPECT_NEAR(value.deviation, 0.004, 1e-9);
            EXPECT_NEAR(value.velocity[0], 0.3, 1e-9);
        } else if (value.found && z > depth + 1.5 * h) {
            EXPECT_LT(value.deviation, 0.004);
            EXPECT_NEAR(value.velocity[0], 0.3, 1e-9);
            ++above;
        }
    }
    EXPECT_GT(without_water, 0);
    EXPECT_GT(above, 0);
}

}  // namespace
}  // namespace riffle::ghost_nodes_test
