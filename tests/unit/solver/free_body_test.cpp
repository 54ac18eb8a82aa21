// Free and turning bodies in water: what they conserve, and that runs repeat to the bit.

#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.hpp"
#include "saved_state.hpp"
#include "small_case.hpp"

namespace riffle::free_body_test {
namespace {

using test::expect_same_bits;

Solid block(double x, double z, double width, double height) {
    Solid solid;
    solid.name = "block";
    solid.x = {x - width / 2, x + width / 2, x + width / 2, x - width / 2};
    solid.z = {z - height / 2, z - height / 2, z + height / 2, z + height / 2};
    solid.motion = SolidMotion::free;
    solid.density = 500.0;
    return solid;
}

/// A body in the middle of a full closed tank.
Case full_tank() {
    Case c;
    c.channel.slope = 0.0;
    c.channel.depth = 0.1;
    c.channel.length = 0.16;
    c.channel.ends = Ends::walls;
    c.channel.top = Top::wall;
    c.bed.kind = BedKind::no_slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.turbulence.closure = ClosureKind::none;
    c.fluid.gravity = 0.0;
    c.numerics.spacing = 0.004;
    c.numerics.sound_speed = 4.0;
    c.start.kind = StartKind::rest;
    c.solids = {block(0.08, 0.05, 0.032, 0.024)};
    return c;
}

/// One that floats and one that sinks, in a tank with a surface.
Case harbour() {
    Case c = full_tank();
    c.channel.top = Top::free_surface;
    c.bed.kind = BedKind::slip;
    c.fluid.gravity = 9.81;
    c.numerics.sound_speed.reset();
    c.solids = {block(0.05, 0.1, 0.032, 0.024), block(0.11, 0.03, 0.032, 0.024)};
    c.solids[1].name = "stone";
    c.solids[1].density = 3000.0;
    return c;
}

struct Momentum {
    double x = 0.0;
    double z = 0.0;
};

Momentum momentum(const Simulation& simulation, double mass) {
    const Particles<2>& p = simulation.particles();
    const Point3& velocity = simulation.clock().free_bodies[0].velocity;
    Momentum sum{mass * velocity[0], mass * velocity[2]};
    for (std::size_t i = 0; i < p.size(); ++i) {
        sum.x += p.mass[i] * p.velocity[0][i];
        sum.z += p.mass[i] * p.velocity[1][i];
    }
    return sum;
}

// Below a wall at the top the particles feel no gravity across the bed: what is heavier than water sinks all
// the same, what is lighter rises.
TEST(FreeBodyInWater, BelowALidHasItsWeightAndBuoyancy) {
    for (const double density : {2500.0, 400.0}) {
        Case c = test::still_water();
        c.channel.length = 0.1;
        c.channel.depth = 0.06;
        c.channel.ends = Ends::walls;
        c.channel.top = Top::wall;
        Solid stone = test::rectangle("stone", 0.04, 0.06, 0.024, 0.036);
        stone.motion = SolidMotion::free;
        stone.density = density;
        c.solids = {stone};
        const auto simulation = test::simulation_of<2>(c);
        while (simulation->clock().time < 0.02) simulation->step();
        // The water that goes around it adds to its mass.
        const double alone = (1000.0 - density) / density * 9.81 * 0.02;
        const double velocity = simulation->clock().free_bodies[0].velocity[2];
        EXPECT_GT(velocity / alone, 0.1) << density;
        EXPECT_LT(velocity / alone, 1.0) << density;
    }
}

// Until the sound is at the walls nothing else takes momentum: what the body loses the water gains, to the
// rounding of the pair sums in single precision.
TEST(FreeBodyInWater, SharesItsMomentumWithTheWater) {
    Case c = full_tank();
    c.solids[0].velocity_x = 0.05;
    c.solids[0].velocity_z = 0.02;
    c.solids[0].angular_velocity = 1.0;
    const double mass = 500.0 * 0.032 * 0.024;
    const auto simulation = test::simulation_of<2>(c);
    simulation->step();
    const double whole = 0.05 * mass;
    while (simulation->clock().time < 0.015 / 4.0) simulation->step();
    const Momentum now = momentum(*simulation, mass);
    EXPECT_LT(simulation->clock().free_bodies[0].velocity[0], 0.045);
    EXPECT_NEAR(now.x, whole, 1e-4 * whole);
    EXPECT_NEAR(now.z, 0.4 * whole, 1e-4 * whole);
}

// Pressure alone would turn it the faster the longer: half a radian a second by then.
TEST(FreeBodyInWater, ALogThatFloatsStaysAsItIs) {
    const Case c = parse_case(R"(
[channel]
slope = 0
depth = "0.2 m"
length = "0.6 m"
ends = "walls"
[bed]
kind = "slip"
[turbulence]
closure = "none"
[numerics]
spacing = "10 mm"
[start]
kind = "rest"
[run]
until = "3 s"
[[solid]]
name = "log"
shape = "circle"
centre = ["0.3 m", "0.2 m"]
diameter = "0.1 m"
motion = "free"
density = 500
)",
                              "log");
    const auto simulation = test::simulation_of<2>(c);
    while (simulation->clock().time < 2.5) simulation->step();
    const FreeBodyState& log = simulation->clock().free_bodies[0];
    EXPECT_LT(std::abs(log.angular_velocity[1]), 0.01);
    EXPECT_LT(std::abs(log.displacement[0]), 0.002);
    EXPECT_LT(std::abs(log.displacement[2]), 0.002);
}

void expect_same_bodies(const Simulation& a, const Simulation& b) {
    ASSERT_EQ(a.clock().free_bodies.size(), b.clock().free_bodies.size());
    for (std::size_t n = 0; n < a.clock().free_bodies.size(); ++n) {
        EXPECT_EQ(a.clock().free_bodies[n].numbers(), b.clock().free_bodies[n].numbers());
    }
    expect_same_bits(a.particles(), b.particles());
}

TEST(FreeBodyInWater, GoesOnFromASavedStateWithTheSameBitsForAnyNumberOfThreads) {
    set_thread_count(1);
    const auto straight = test::simulation_of<2>(harbour());
    for (int i = 0; i < 60; ++i) straight->step(i % 7 == 0 ? 0.0 : 1e9);
    const auto resumed = test::simulation_of<2>(harbour());
    resumed->restore(test::saved_particles(*straight), straight->clock(), straight->wall_density_deviation());
    set_thread_count(2);
    for (int i = 0; i < 60; ++i) resumed->step(i % 5 == 0 ? 0.0 : 1e9);
    set_thread_count(1);
    for (int i = 0; i < 60; ++i) straight->step(1e9);
    expect_same_bodies(*straight, *resumed);
    EXPECT_NE(straight->clock().free_bodies[0].velocity[2], 0.0);
    EXPECT_NE(straight->clock().free_bodies[1].angular_velocity[1], 0.0);
}

// The body that turns as prescribed: wall particles keep their distances, and stand where the angle says.
TEST(TurningSolid, ItsWallParticlesTurnWithIt) {
    Case c = full_tank();
    Solid& solid = c.solids[0];
    solid.motion = SolidMotion::constant;
    solid.density.reset();
    solid.angular_velocity = 2.0;
    c.fluid.kinematic_viscosity = 1e-3;
    const auto simulation = test::simulation_of<2>(c);
    const WallParticles<2> before = simulation->walls();
    while (simulation->clock().time < 0.05) simulation->step(1e9);
    double largest = 0.0;
    for (std::size_t i = 0; i < simulation->walls().size(); ++i) {
        if (simulation->walls().body[i] != first_solid) continue;
        largest = std::max(largest, std::hypot(simulation->walls().position[0][i] - 0.08,
                                               simulation->walls().position[1][i] - 0.05));
    }
    double largest_before = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before.body[i] != first_solid) continue;
        largest_before =
            std::max(largest_before, std::hypot(before.position[0][i] - 0.08, before.position[1][i] - 0.05));
    }
    EXPECT_NEAR(largest, largest_before, 1e-9);
    // The water near it goes along: against the sense of the clock about -y, with it about y.
    const Particles<2>& p = simulation->particles();
    double spin = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        spin += p.mass[i] *
                ((p.position[1][i] - 0.05) * p.velocity[0][i] - (p.position[0][i] - 0.08) * p.velocity[1][i]);
    }
    EXPECT_GT(spin, 0.0);
}

}  // namespace
}  // namespace riffle::free_body_test
