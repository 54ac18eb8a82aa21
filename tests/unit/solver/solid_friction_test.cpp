// The friction of solids whose surface has a log law.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "particles/force_on_solid.hpp"
#include "roughness/log_law_friction.hpp"
#include "small_case.hpp"

namespace riffle::solid_friction_test {
namespace {

/// Water 40 mm deep over a slab of concrete that lies on the floor of all of a periodic channel.
Case over_slab() {
    Case c;
    c.channel.depth = 0.05;
    c.channel.length = 0.12;
    c.channel.slope = 0.001;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.numerics.spacing = 0.0025;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.5;
    c.solids = {test::rectangle("slab", -0.05, 0.17, 0.0, 0.01)};
    c.solids[0].surface = SolidSurface::log_law;
    c.solids[0].equivalent_roughness = 5e-4;
    return c;
}

std::unique_ptr<Simulation> started(const Case& c) {
    auto simulation = test::simulation_of<2>(c);
    simulation->step();
    return simulation;
}

TEST(SolidFriction, OfUniformWaterIsThatOfTheLogLaw) {
    const Case c = over_slab();
    const auto simulation = started(c);
    const ForceOnSolid& force = simulation->solid_forces().front();
    const double layer = 3 * c.numerics.spacing;
    const double beta = solid_friction(c, c.solids[0]).coefficient(0.25);
    const double expected = c.fluid.density * beta * 0.25 * layer * c.channel.length;
    EXPECT_NEAR(force.friction[0], expected, 0.01 * expected);
    EXPECT_NEAR(force.friction[2], 0.0, 0.01 * expected);
    // It is what the walls take from the water.
    double taken = 0.0;
    for (std::size_t i = 0; i < simulation->particles().size(); ++i) {
        taken -= simulation->particles().mass[i] * simulation->fields().wall_acceleration_x[i];
    }
    EXPECT_NEAR(force.friction[0] + force.pressure[0], taken, 1e-4 * expected);
    // So the balance of momentum knows of it, and the energy that it takes is that of friction.
    double given = 0.0;
    for (std::size_t i = 0; i < simulation->particles().size(); ++i) {
        given += simulation->particles().mass[i] * (simulation->fields().pair_acceleration_x[i] +
                                                    simulation->fields().viscous_acceleration_x[i]);
    }
    EXPECT_NEAR(given, -taken, 1e-4 * expected);
    const EnergyRates& rates = simulation->energy_rates();
    EXPECT_NEAR(rates.viscosity, -0.5 * expected, 0.02 * expected);
    EXPECT_NEAR(rates.further_forces, 0.0, 1e-4 * expected);
}

// On a patch by its own roughness, at its edge by the shares of both, and nothing counts twice.
TEST(SolidFriction, OfAPatchIsByItsOwnRoughness) {
    Case c = over_slab();
    SurfacePatch rough;
    rough.name = "gravel";
    rough.solid = "slab";
    rough.equivalent_roughness = 4e-3;
    rough.x_from = 0.03;
    rough.x_to = 0.0785;
    SurfacePatch glass = rough;
    glass.name = "glass";
    glass.equivalent_roughness = 0.0;
    glass.x_from = 0.0785;
    glass.x_to.reset();
    c.surface_patches = {rough, glass};
    const double friction = started(c)->solid_forces().front().friction[0];
    const double layer = 3 * c.numerics.spacing;
    const double by_lengths = solid_friction(c, c.solids[0]).coefficient(0.25) * 0.03 +
                              solid_friction(c, rough).coefficient(0.25) * 0.0485 +
                              solid_friction(c, glass).coefficient(0.25) * 0.0415;
    const double expected = c.fluid.density * by_lengths * 0.25 * layer;
    EXPECT_NEAR(friction, expected, 0.01 * expected);
    EXPECT_GT(solid_friction(c, rough).coefficient(0.25), 1.5 * solid_friction(c, glass).coefficient(0.25));
}

TEST(SolidFriction, IsByTheVelocityPastTheSurface) {
    Case c = over_slab();
    c.channel.length = 0.3;
    c.solids = {test::rectangle("raft", 0.1, 0.2, 0.02, 0.04)};
    c.solids[0].surface = SolidSurface::log_law;
    c.solids[0].motion = SolidMotion::constant;
    c.solids[0].velocity_x = 0.5;
    c.channel.slope = 0.0;
    const auto friction = [&](double velocity) {
        c.solids[0].velocity_x = velocity;
        const auto simulation = started(c);  // which is the step in which it begins to move
        simulation->step(0.0);
        return simulation->solid_forces().front().friction[0];
    };
    const double slower = friction(0.0);
    const double faster = friction(1.0);
    const double with_the_water = std::abs(friction(0.5));
    EXPECT_LT(with_the_water, 0.01 * slower);
    EXPECT_GT(slower, 0.0);
    EXPECT_NEAR(faster, -slower, 0.05 * slower);
}

// Banks that run along the channel push nothing along it but by friction, though the pressure of the water, a
// thousand times the stress of this slope, presses on them, and its particles lie in no order.
TEST(SolidFriction, IsAllThatBanksDoAlongTheChannel) {
    Case c = over_slab();
    c.channel.dimensions = 3;
    c.channel.sides = Sides::walls;
    c.channel.length = 0.06;
    c.channel.width = 0.12;
    c.numerics.spacing = 0.005;
    c.side_walls.drag_form = SideDragForm::none;
    c.start.jitter = 0.2;
    c.solids[0].shape = SolidShape::section;
    c.solids[0].x.clear();
    c.solids[0].z.clear();
    c.solids[0].y = {0.0, 0.02, 0.02, 0.1, 0.1, 0.12};
    c.solids[0].levels = {0.06, 0.06, 0.0, 0.0, 0.06, 0.06};
    const auto simulation = test::simulation_of<3>(c);
    double pressure = 0.0;
    constexpr int steps = 1000;
    for (int step = 0; step < steps; ++step) {
        simulation->step(0.0);
        if (step >= steps / 2) pressure += 2.0 * simulation->solid_forces().front().pressure[0] / steps;
    }
    const double weight = c.fluid.density * c.streamwise_gravity() * 0.05 * 0.08 * 0.06;
    // Sound makes it swing by 0.6 of the weight: the mean of these steps is known to 0.13 of it. With banks
    // that continue the water along the channel too it was -0.63 of the weight.
    EXPECT_NEAR(pressure, 0.0, 0.35 * weight);
}

TEST(SolidFriction, HasTheSameBitsForAnyNumberOfThreads) {
    const Case c = over_slab();
    const auto run = [&](int threads) {
        set_thread_count(threads);
        const auto simulation = started(c);
        for (int step = 0; step < 20; ++step) simulation->step();
        set_thread_count(0);
        return std::pair(simulation->particles().velocity[0], simulation->solid_forces().front().friction[0]);
    };
    EXPECT_EQ(run(1), run(2));
}

}  // namespace
}  // namespace riffle::solid_friction_test
