// What the instruments read off the particles in three dimensions.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "instruments/instrument.hpp"
#include "water.hpp"
#include "working.hpp"

namespace riffle::space_test {
namespace {

using test::values_of;

using Field3 = std::function<double(double x, double y, double z)>;

/// A periodic channel of 60 x 48 mm with 30 mm of water and particles 3 mm apart.
Case small_space() {
    Case c = test::small_water();
    c.channel.dimensions = 3;
    c.channel.length = 0.06;
    c.channel.width = 0.048;
    c.channel.depth = 0.03;
    c.numerics.spacing = 0.003;
    return c;
}

/// Its particles, displaced at random, with a velocity field and a surface at depth + rise(x, y).
struct Space {
    Case parameters;
    Particles<3> particles;
    double h;

    explicit Space(const Case& c, double jitter = 0.0, const std::function<double(double, double)>& rise = {})
        : parameters(c), h(c.numerics.smoothing_ratio * c.numerics.spacing) {
        Case displaced = c;
        displaced.start.jitter = jitter;
        particles = lattice_particles<3>(displaced);
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const double stretch =
                rise ? 1.0 + rise(particles.position[0][i], particles.position[1][i]) / c.total_depth() : 1.0;
            particles.position[2][i] *= stretch;
            particles.mass[i] = c.fluid.density * lattice_of(c).volume() * stretch;
        }
    }
    Space& with_velocity(const Field3& u, const Field3& v, const Field3& w) {
        const auto& [x, y, z] = particles.position;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            particles.velocity[0][i] = u(x[i], y[i], z[i]);
            particles.velocity[1][i] = v(x[i], y[i], z[i]);
            particles.velocity[2][i] = w(x[i], y[i], z[i]);
        }
        return *this;
    }
    [[nodiscard]] FluidViewIn<3> view() const { return {parameters, particles, h}; }
    void sample(Instrument& instrument, double time = 1.0) const {
        const FluidViewIn<3> fluid = view();
        const std::vector<double> zero(particles.size(), 0.0);
        const WorkingValues no_pressure = test::working(zero);
        instrument.sample({.time = time,
                           .mass = particles.mass,
                           .fluid = &fluid,
                           .pressure = &no_pressure,
                           .shear_stress = zero});
    }
};

constexpr auto nothing = [](double, double, double) { return 0.0; };

Probe probe(ProbeKind kind) {
    Probe p;
    p.name = "p";
    p.kind = kind;
    p.sampling_frequency = 100.0;
    return p;
}

TEST(FluidViewInSpace, ReproducesALinearFieldInDisorderedWater) {
    // Exact up to the rounding of sums of some hundred terms of order 1 m/s.
    const Field3 u = [](double x, double y, double z) { return 0.1 + 3.0 * x - 5.0 * y + 12.0 * z; };
    const Field3 v = [](double x, double y, double z) { return 2.0 * y - x + z; };
    const Field3 w = [](double x, double y, double z) { return 0.02 + x + y - 0.5 * z; };
    const Space water = Space(small_space(), 0.4).with_velocity(u, v, w);
    const FluidViewIn<3> view = water.view();
    for (const double x : {0.0301, 0.0255}) {
        for (const double y : {0.0207, 0.0281}) {
            for (const double z : {0.0011, 0.0123, 0.0292}) {
                const auto read = view.velocity_at({x, y, z});
                EXPECT_NEAR(read.u, u(x, y, z), 1e-12);
                EXPECT_NEAR(read.v, v(x, y, z), 1e-12);
                EXPECT_NEAR(read.w, w(x, y, z), 1e-12);
            }
        }
    }
}

TEST(FluidViewInSpace, ReadsThePeriodicImagesAcrossTheChannel) {
    // Once through the middle of its period, once at its ends.
    const Space water =
        Space(small_space(), 0.3)
            .with_velocity(
                [](double, double y, double) { return std::cos(2.0 * std::numbers::pi * y / 0.048); },
                nothing, nothing);
    const FluidViewIn<3> view = water.view();
    EXPECT_DOUBLE_EQ(view.velocity_at({0.03, 0.0, 0.015}).u, view.velocity_at({0.03, 0.048, 0.015}).u);
    // The kernel's second moment flattens the crest by its share of the curvature: 0.2 h^2 k^2/2.
    EXPECT_NEAR(view.velocity_at({0.03, 0.0, 0.015}).u, 1.0, 0.2);
    EXPECT_NEAR(view.velocity_at({0.03, 0.024, 0.015}).u, -1.0, 0.2);
}

TEST(FluidViewInSpace, IsDryAboveTheSurface) {
    const Space water = Space(small_space());
    const FluidViewIn<3> view = water.view();
    EXPECT_TRUE(std::isfinite(view.velocity_at({0.03, 0.02, 0.0297}).u));
    EXPECT_TRUE(std::isnan(view.velocity_at({0.03, 0.02, 0.0303}).u));
}

TEST(FluidViewInSpace, FlowRateIsTheMassFlux) {
    // Midpoint sums of a C2 kernel every half spacing are exact to 1e-4.
    const Space water =
        Space(small_space(), 0.4,
              [](double x, double y) { return 0.002 * std::sin(105.0 * x) * std::cos(131.0 * y); })
            .with_velocity([](double x, double y, double z) { return 10.0 * z + std::sin(60.0 * x) + y; },
                           [](double, double, double) { return 0.1; }, nothing);
    const FluidViewIn<3> view = water.view();
    const int sections = 40;
    double rate = 0.0;
    double depth = 0.0;
    for (int i = 0; i < sections; ++i) {
        const auto section = view.section_at((i + 0.5) * 0.06 / sections);
        rate += section.flow_rate / sections;
        depth += section.depth / sections;
    }
    double momentum = 0.0;
    double mass = 0.0;
    for (std::size_t i = 0; i < water.particles.size(); ++i) {
        mass += water.particles.mass[i];
        momentum += water.particles.mass[i] * water.particles.velocity[0][i];
    }
    EXPECT_NEAR(rate, momentum / (1000.0 * 0.06), 1e-4 * momentum / (1000.0 * 0.06));
    EXPECT_NEAR(depth, mass / (1000.0 * 0.06 * 0.048), 1e-4 * 0.03);
}

TEST(FluidViewInSpace, FollowsASurfaceThatWavesAcross) {
    const auto rise = [](double, double y) { return 0.002 * std::sin(2.0 * std::numbers::pi * y / 0.048); };
    const Space water(small_space(), 0.0, rise);
    std::vector<Vec<2>> places;
    for (int i = 0; i < 12; ++i) {
        places.push_back({0.03, i * 0.004});
    }
    const std::vector<double> elevation = water.view().surface_at(places);
    for (std::size_t i = 0; i < places.size(); ++i) {
        // The surface is found to 0.2 spacings, with the flattening of a wave of 8 h by its kernel in it.
        EXPECT_NEAR(elevation[i], 0.03 + rise(0.0, places[i][1]), 0.2 * 0.003);
    }
}

TEST(FluidViewInSpace, ReachesTheSideWallAndThePlaneOfSymmetry) {
    // Half of a channel: a wall at y = 0, its centreline at 48 mm. There too the water fills the support.
    Case c = small_space();
    c.channel.sides = Sides::half;
    c.channel.width = 0.096;
    const Field3 u = [](double, double y, double z) { return 2.0 * y + 5.0 * z; };
    const Space water = Space(c, 0.3).with_velocity(u, nothing, nothing);
    const FluidViewIn<3> view = water.view();
    for (const double y : {0.0, 0.0005, 0.0477, 0.048}) {
        for (const double z : {0.004, 0.02, 0.0285}) {
            EXPECT_NEAR(view.velocity_at({0.03, y, z}).u, u(0.0, y, z), 1e-12) << y << ", " << z;
        }
        EXPECT_TRUE(std::isnan(view.velocity_at({0.03, y, 0.033}).u));
        // Disordered by up to 0.3 spacings, the surface is found to half a spacing.
        EXPECT_NEAR(view.surface_at(std::vector<Vec<2>>{{0.03, y}})[0], 0.03, 0.5 * 0.003);
    }
    // The mirror images are no water of the section.
    const auto section = view.section_at(0.03);
    EXPECT_NEAR(section.depth, 0.03, 0.02 * 0.03);
    EXPECT_NEAR(section.flow_rate / (section.depth * 0.048), 2.0 * 0.024 + 5.0 * 0.015, 0.02 * 0.12);
}

TEST(InstrumentsInSpace, RecordTheVelocityAcrossAtTheirPlaces) {
    const Space water = Space(small_space(), 0.3)
                            .with_velocity([](double, double y, double) { return y; },
                                           [](double, double y, double z) { return 2.0 * y + z; }, nothing);
    Probe p = probe(ProbeKind::velocity);
    p.x = {0.03};
    p.z = {0.01, 0.02};
    const auto centre = make_instrument(p, water.parameters);
    p.y = {0.02, 0.03};
    const auto pair = make_instrument(p, water.parameters);
    const std::vector<std::pair<Instrument*, std::array<double, 2>>> expected = {
        {centre.get(), {0.024, 0.024}}, {pair.get(), {0.02, 0.03}}};
    for (const auto& [instrument, y] : expected) {
        water.sample(*instrument);
        ASSERT_EQ(instrument->axes()[1].name, "y");
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_DOUBLE_EQ(instrument->axes()[1].values[i], y[i]);
            EXPECT_NEAR(values_of(*instrument, "velocity")[i], y[i], 1e-7);  // single precision
            EXPECT_NEAR(values_of(*instrument, "spanwise_velocity")[i], 2.0 * y[i] + p.z[i], 1e-7);
        }
    }
}

TEST(InstrumentsInSpace, OfAGridAverageTheVelocityAcross) {
    Probe p = probe(ProbeKind::grid);
    p.sampling_frequency = 10.0;
    p.spacing = 0.01;
    p.x_from = 0.02;
    p.x_to = 0.03;
    p.z_from = 0.01;
    p.z_to = 0.02;
    p.averaging_time = 0.4;
    p.y = {0.011};
    const auto instrument = make_instrument(p, small_space());
    const auto other = make_instrument(p, small_space());
    for (int k = 1; k <= 4; ++k) {
        const double v = k % 2 == 0 ? 0.3 : 0.1;
        const Space water = Space(small_space())
                                .with_velocity(
                                    nothing, [=](double, double, double) { return v; }, nothing);
        water.sample(*instrument, 0.1 * k + 1e-4);
        if (k == 3) other->restore_unfinished(instrument->unfinished());
        if (k == 4) water.sample(*other, 0.1 * k + 1e-4);
    }
    EXPECT_NEAR(values_of(*instrument, "spanwise_velocity")[1], 0.2, 1e-6);
    EXPECT_NEAR(values_of(*instrument, "spanwise_velocity_variance")[1], 0.01, 1e-6);
    EXPECT_EQ(values_of(*instrument, "spanwise_velocity_variance"),
              values_of(*other, "spanwise_velocity_variance"));
}

TEST(InstrumentsInSpace, SumTheDragOfTheSideWalls) {
    const Space water(small_space());
    const auto instrument = make_instrument(probe(ProbeKind::force), water.parameters);
    const std::size_t n = water.particles.size();
    SparseValues zero;
    SparseValues sides;
    zero.reset(n);
    sides.reset(n);
    for (std::size_t i = 0; i < n; ++i) sides.set(i, -0.02);
    instrument->sample({.mass = water.particles.mass,
                        .drag_x = &zero,
                        .wall_x = &zero,
                        .wall_z = &zero,
                        .side_wall_x = &sides});
    const double mass = 1000.0 * 0.06 * 0.048 * 0.03;
    EXPECT_NEAR(values_of(*instrument, "side_wall_drag")[0], 0.02 * mass, 1e-12);
    EXPECT_EQ(instrument->records()[1].unit, "N");
}

}  // namespace
}  // namespace riffle::space_test
