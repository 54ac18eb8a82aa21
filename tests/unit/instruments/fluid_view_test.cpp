// What the instruments read off the particles: known fields, surfaces and discharges.

#include "instruments/fluid_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "boundary/wall.hpp"
#include "water.hpp"

namespace riffle::fluid_view_test {
namespace {

using test::small_water;
using test::Water;

TEST(FluidView, ReproducesALinearFieldAnywhereInDisorderedWater) {
    // The fit is exact for a plane: what is left is rounding, of sums of some hundred terms of order 1 m/s.
    const Water water = Water(small_water(), 0.4)
                            .with_velocity([](double, double z) { return 0.1 + 12.0 * z; },
                                           [](double, double z) { return 0.02 - 0.5 * z; });
    const FluidViewIn<2> view = water.view();
    for (const double x : {0.0, 0.0137, 0.05, 0.0999}) {
        for (const double z : {0.0011, 0.005, 0.0203, 0.036, 0.0392}) {
            const auto v = view.velocity_at({x, 0.0, z});
            EXPECT_NEAR(v.u, 0.1 + 12.0 * z, 1e-12) << x << ", " << z;
            EXPECT_NEAR(v.w, 0.02 - 0.5 * z, 1e-12) << x << ", " << z;
        }
    }
}

TEST(FluidView, ReproducesALinearFieldAlongTheChannelAwayFromItsEnds) {
    const Water water = Water(small_water(), 0.4)
                            .with_velocity([](double x, double z) { return 3.0 * x - 2.0 * z; },
                                           [](double x, double) { return 0.5 * x; });
    const FluidViewIn<2> view = water.view();
    for (const double x : {0.02, 0.0431, 0.08}) {
        const auto v = view.velocity_at({x, 0.0, 0.0123});
        EXPECT_NEAR(v.u, 3.0 * x - 2.0 * 0.0123, 1e-12);
        EXPECT_NEAR(v.w, 0.5 * x, 1e-12);
    }
}

TEST(FluidView, SmoothsACurvedFieldByTheKernelsSecondMoment) {
    // On a lattice inside the water the error of u = c z^2 is c times the second moment of the kernel,
    // int z^2 W = 5/18 h^2 for Wendland C2 in two dimensions; a tenth of it for the lattice's sums.
    const double c = 100.0;
    const Water water =
        Water(small_water())
            .with_velocity([=](double, double z) { return c * z * z; }, [](double, double) { return 0.0; });
    const double z = 0.0203;
    const double moment = 5.0 / 18.0 * water.h * water.h;
    EXPECT_NEAR(water.view().velocity_at({0.05, 0.0, z}).u - c * z * z, c * moment, 0.1 * c * moment);
}

TEST(FluidView, ReadsUniformFlowAndItsPeriodicImages) {
    const Water water =
        Water(small_water(), 0.3)
            .with_velocity([](double, double) { return 0.35; }, [](double, double) { return 0.0; });
    const FluidViewIn<2> view = water.view();
    EXPECT_NEAR(view.velocity_at({0.0, 0.0, 0.02}).u, 0.35, 1e-14);
    EXPECT_DOUBLE_EQ(view.velocity_at({0.0, 0.0, 0.02}).u, view.velocity_at({0.1, 0.0, 0.02}).u);
    EXPECT_NEAR(view.velocity_at({0.03, 0.0, 0.02}).w, 0.0, 1e-15);
}

TEST(FluidView, IsDryAboveTheSurface) {
    const Water water =
        Water(small_water())
            .with_velocity([](double, double) { return 1.0; }, [](double, double) { return 0.0; });
    const FluidViewIn<2> view = water.view();
    // Half of the support is filled on the surface itself, to the lattice's tenth of a spacing.
    EXPECT_TRUE(std::isfinite(view.velocity_at({0.05, 0.0, 0.04 - 0.0002}).u));
    EXPECT_TRUE(std::isnan(view.velocity_at({0.05, 0.0, 0.04 + 0.0002}).u));
    EXPECT_TRUE(std::isnan(view.velocity_at({0.05, 0.0, 0.07}).w));
}

TEST(FluidView, SeesTheWaterAtAnEndWallAsHighAsBesideIt) {
    Case c = small_water();
    c.channel.slope = 0.0;
    c.channel.ends = Ends::walls;
    const Water water = Water(c, 0.3).with_velocity([](double, double z) { return 12.0 * z; },
                                                    [](double, double) { return 0.0; });
    const FluidViewIn<2> view = water.view();
    // Disordered by up to 0.3 spacings, the surface is found to half a spacing. Without the water behind the
    // wall it would stand a smoothing length lower, two spacings, and the point near it would be dry.
    for (const double x : {0.0, 0.001, 0.099, 0.1}) {
        EXPECT_NEAR(view.surface_at(std::vector<Vec<2>>{{x, 0.0}})[0], 0.04, 0.5 * 0.002) << x;
        EXPECT_NEAR(view.velocity_at({x, 0.0, 0.037}).u, 12.0 * 0.037, 1e-12) << x;
    }
}

TEST(FluidView, SeesTheWaterBesideAPierAndThinWaterAsHighAsItIs) {
    for (const double depth : {0.04, 0.004}) {
        Case c = small_water();
        c.channel.slope = 0.0;
        c.channel.depth = depth;
        c.channel.ends = Ends::walls;
        Solid pier;
        pier.name = "pier";
        pier.x = {0.04, 0.06, 0.06, 0.04};
        pier.z = {-0.02, -0.02, 0.07, 0.07};
        c.solids.push_back(pier);
        const Water water(c);
        const WallParticles<2> walls = wall_particles(c);
        const FluidViewIn<2> view(water.parameters, water.particles, water.h, &walls);
        for (const double x : {0.0, 0.02, 0.036, 0.039, 0.061, 0.07, 0.1}) {
            EXPECT_NEAR(view.surface_at(std::vector<Vec<2>>{{x, 0.0}})[0], depth, 0.15 * 0.002) << x;
        }
        EXPECT_TRUE(std::isnan(view.surface_at(std::vector<Vec<2>>{{0.05, 0.0}})[0]));
    }
}

TEST(FluidView, FindsNeighboursInTheShortestPeriodicChannel) {
    // Two supports long, the least that a case may be: each neighbour must count once.
    Case c = small_water();
    c.channel.length = 0.020;
    const Water water =
        Water(c).with_velocity([](double, double z) { return z; }, [](double, double) { return 0.0; });
    for (const double x : {0.0, 0.004, 0.0101, 0.0199}) {
        EXPECT_NEAR(water.view().velocity_at({x, 0.0, 0.02}).u, 0.02, 1e-14);
        // Sums of the kernel over a lattice at h = 2 dx are 1 to 1 %.
        EXPECT_NEAR(water.view().section_at(x).depth, 0.04, 0.01 * 0.04);
    }
}

TEST(FluidView, FlowRateOfUniformFlowIsVelocityTimesDepth) {
    const double u = 0.35;
    const Water water =
        Water(small_water())
            .with_velocity([=](double, double) { return u; }, [](double, double) { return 0.0; });
    for (const double x : {0.0, 0.031, 0.0502}) {
        const auto section = water.view().section_at(x);
        EXPECT_NEAR(section.flow_rate, u * section.depth, 1e-14);
        EXPECT_NEAR(section.depth, 0.04, 0.01 * 0.04);  // sum of the kernel over a lattice
    }
}

TEST(FluidView, MomentumOfASectionIsItsFluxAndTheForceOfThePressure) {
    const double u = 0.35;
    const Water water =
        Water(small_water())
            .with_velocity([=](double, double) { return u; }, [](double, double) { return 0.0; });
    const WorkingValues pressure =
        test::working(water.of_particles([](double, double z) { return 9810.0 * (0.04 - z); }));
    for (const double x : {0.0, 0.031, 0.0502}) {
        const auto section = water.view().section_at(x, &pressure);
        EXPECT_NEAR(section.momentum_flux, 1000.0 * u * u * section.depth, 1e-10);
        EXPECT_NEAR(section.pressure_force, 0.5 * 9810.0 * 0.04 * 0.04, 0.01 * 7.848);
    }
}

TEST(FluidView, EnergyOfASectionIsItsDischargeTimesTheHead) {
    const double u = 0.35;
    const Water water =
        Water(small_water())
            .with_velocity([=](double, double) { return u; }, [](double, double) { return 0.0; });
    const double gravity = water.parameters.normal_gravity();
    const WorkingValues pressure =
        test::working(water.of_particles([=](double, double z) { return 1000.0 * gravity * (0.04 - z); }));
    for (const double x : {0.0, 0.031, 0.0502}) {
        const auto section = water.view().section_at(x, &pressure);
        // Over the bed: depth and velocity head. The weights are those of the discharge.
        const double head = 0.04 + u * u / (2.0 * gravity);
        EXPECT_NEAR(section.energy_flux, 1000.0 * gravity * section.flow_rate * head,
                    1e-10 * section.energy_flux);
    }
}

TEST(FluidView, FlowRateIsTheMassFlux) {
    // The mean of the flow rate over the channel is the streamwise momentum of the water over its density and
    // length, whatever the flow. Midpoint sums of a C2 kernel every half spacing are exact to 1e-4.
    const Water water =
        Water(small_water(), 0.4, [](double x) { return 0.004 * std::sin(2.0 * std::numbers::pi * x / 0.1); })
            .with_velocity([](double x, double z) { return 10.0 * z + std::sin(60.0 * x); },
                           [](double, double) { return 0.1; });
    const FluidViewIn<2> view = water.view();
    const int sections = 100;
    double mean = 0.0;
    for (int i = 0; i < sections; ++i) {
        mean += view.section_at((i + 0.5) * 0.1 / sections).flow_rate / sections;
    }
    double momentum = 0.0;
    for (std::size_t i = 0; i < water.particles.size(); ++i) {
        momentum += water.particles.mass[i] * water.particles.velocity[0][i];
    }
    const double flux = momentum / (water.parameters.fluid.density * 0.1);
    EXPECT_NEAR(mean, flux, 1e-4 * std::abs(flux));
}

TEST(FluidView, FollowsASineSurface) {
    const double amplitude = 0.003;
    const auto wave = [&](double x) { return amplitude * std::sin(2.0 * std::numbers::pi * x / 0.1); };
    const Water water(small_water(), 0.0, wave);
    std::vector<Vec<2>> x(25);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = {static_cast<double>(i) * 0.004, 0.0};
    }
    const std::vector<double> elevation = water.view().surface_at(x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        // The surface is found to 0.15 spacings, with the flattening of a wave of 25 h by its kernel in it.
        EXPECT_NEAR(elevation[i], 0.04 + wave(x[i][0]), 0.15 * 0.002);
    }
}

}  // namespace
}  // namespace riffle::fluid_view_test
