// The hydrostatic part of the pressure that acts as a function of the height.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/pair_setup.hpp"
#include "engine/particle_fault.hpp"
#include "same_bits.hpp"
#include "small_case.hpp"

namespace riffle::reference_pressure_test {
namespace {

TEST(HydrostaticReference, IsTheWeightOfTheWaterBelowItsMiddle) {
    const HydrostaticReference reference{.level = 0.5, .fade = 0.2, .gravity = 9.81};
    EXPECT_EQ(reference.value(0.5), 0.0);
    EXPECT_EQ(reference.slope(0.6), 0.0);
    EXPECT_NEAR(reference.slope(0.4), 0.5 * 9.81, 1e-14);
    EXPECT_NEAR(reference.value(0.1), 9.81 * 0.3, 1e-14);
    EXPECT_NEAR(reference.slope(0.1), 9.81, 1e-14);
    for (const double z : {0.05, 0.29, 0.31, 0.4, 0.49, 0.51}) {
        EXPECT_NEAR(reference.slope(z), (reference.value(z - 1e-6) - reference.value(z + 1e-6)) / 2e-6, 1e-8);
    }
}

Case with_reference(Case c) {
    c.numerics.reference_pressure = ReferencePressure::hydrostatic;
    return c;
}

/// A closed tank of water, ten spacings deep.
template <int D>
Case tank() {
    Case c = test::still_water(D);
    c.channel.dimensions = D;
    c.channel.ends = Ends::walls;
    if (D == 3) c.channel.sides = Sides::walls;
    c.numerics.spacing = 0.005;
    return c;
}

/// A tank of water after half a second, in which its uppermost rows have come closer (verification.md).
template <int D>
test::ChannelIn<D> settled(const Case& c) {
    test::ChannelIn<D> water(c);
    water.advance_to(0.5);
    return water;
}

template <int D>
void expect_water_to_stay_at_rest() {
    const Case c = with_reference(tank<D>());
    const test::ChannelIn<D> water = settled<D>(c);
    const Particles<D>& p = water.simulation->particles();
    const double by_pairs = test::rms_speed(settled<D>(tank<D>()).simulation->particles());
    EXPECT_LT(test::rms_speed(p), 1.1 * by_pairs);
    const double weight = c.fluid.gravity * c.channel.depth;
    const double support = 2.0 * water.simulation->scheme().smoothing_length;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.position[D - 1][i] > c.channel.depth - support) {
            continue;  // rows below a surface, which its pressure knows by their pairs
        }
        const double pressure = water.simulation->scheme().state.pressure(p.density_deviation[i]);
        EXPECT_NEAR(pressure, c.fluid.gravity * (c.channel.depth - p.position[D - 1][i]), 0.03 * weight);
    }
}

TEST(ReferencePressure, WaterAtRestStaysHydrostatic) {
    expect_water_to_stay_at_rest<2>();
    expect_water_to_stay_at_rest<3>();
}

// What disorder makes of the pressure is in proportion to the pressure of the pairs.
TEST(ReferencePressure, LetsDisorderedWaterComeToRest) {
    const auto speed_after = [](const Case& of, double time) {
        const test::Channel water(of);
        water.advance_to(time);
        return test::rms_speed(water.simulation->particles());
    };
    const Case c = test::disordered_tank();
    EXPECT_LT(speed_after(with_reference(c), 1.5), 0.5 * speed_after(c, 1.5));
}

TEST(ReferencePressure, AResumedRunHasTheSameBitsOnAnyNumberOfThreads) {
    Case c = with_reference(test::small_channel());
    c.start.jitter = 0.1;
    test::expect_same_bits_after_resume(c, 60, 60);
}

ForceOnSolid force_at_start(const Case& c) {
    const test::Channel water(c);
    water.advance(1);
    return water.simulation->solid_forces().front();
}

// A block in the water is lifted by what it displaces, one on the bed is pressed down by what stands on it.
TEST(ReferencePressure, PressesOnSolids) {
    Case c = tank<2>();
    c.channel.length = 0.12;
    c.numerics.spacing = 0.0025;
    c.solids = {test::rectangle("block", 0.04, 0.08, 0.015, 0.035)};
    const double weight = c.fluid.density * c.fluid.gravity;
    EXPECT_NEAR(force_at_start(with_reference(c)).pressure[2], weight * 0.04 * 0.02,
                0.02 * weight * 0.04 * 0.02);
    c.solids = {test::rectangle("block", 0.02, 0.06, 0.0, 0.02)};
    const ForceOnSolid pressed = force_at_start(with_reference(c));
    EXPECT_NEAR(pressed.pressure[2], -weight * 0.04 * 0.03, 0.02 * weight * 0.04 * 0.03);
    EXPECT_NEAR(pressed.pressure[0], 0.0, 0.01 * weight * 0.05 * 0.05);
    // Beside a wall only the other face is wet: it bears the pressure from 50 mm below the surface up.
    c.solids = {test::rectangle("block", 0.0, 0.04, 0.0, 0.02)};
    const ForceOnSolid beside = force_at_start(with_reference(c));
    EXPECT_NEAR(beside.pressure[0], -weight * 0.04 * 0.02, 0.04 * weight * 0.04 * 0.02);
    // About its middle: the integral of (z - 0.01)(0.05 - z) over that face.
    const double moment = weight * 2.0 / 3.0 * 1e-6;
    // What the pairs carry of it has their error.
    const double by_pairs = force_at_start(c).pressure_moment[1];
    EXPECT_LT(std::abs(beside.pressure_moment[1] - moment), 0.7 * std::abs(by_pairs - moment));
}

TEST(ReferencePressure, TheBedBearsTheWater) {
    const Case c = with_reference(test::still_water());
    const test::Channel water(c);
    water.advance(1);
    const SimulationIn<2>& simulation = *water.simulation;
    const Particles<2>& p = simulation.particles();
    double force = 0.0;
    double weight = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        force += p.mass[i] * simulation.fields().wall_acceleration_z[i];
        weight += p.mass[i] * c.fluid.gravity;
    }
    EXPECT_NEAR(force, weight, 0.02 * weight);
}

TEST(ReferencePressure, EndsWhereTheSurfaceFallsTooLow) {
    Case c = with_reference(tank<2>());
    c.channel.length = 0.3;
    c.start.water_x = {0.0, 0.1, 0.1, 0.0};
    c.start.water_z = {0.0, 0.0, 0.05, 0.05};
    const test::Channel dam(c);
    try {
        for (int step = 0; step < 400; ++step) dam.advance(1);
        FAIL() << "the water fell without a word";
    } catch (const ParticleFault& fault) {
        const std::string message = fault.what();
        EXPECT_NE(message.find("surface has come below"), std::string::npos) << message;
        EXPECT_NE(message.find("reference_depth_ratio"), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace riffle::reference_pressure_test
