// Pressure gauges: what they read in still water, at dry places and under an uneven pressure.

#include <gtest/gtest.h>

#include "instruments/instrument.hpp"
#include "water.hpp"
#include "working.hpp"

namespace riffle::pressure_gauge_test {
namespace {

using test::small_water;
using test::values_of;
using test::Water;

constexpr double weight = 1000.0 * 9.81;  // rho g, Pa/m

/// A tank of 0.1 m with still water, the particles displaced by up to 0.3 spacings.
Case tank() {
    Case c = small_water();
    c.channel.slope = 0.0;
    c.channel.ends = Ends::walls;
    c.channel.wall_height = 0.1;
    return c;
}

Probe gauges(std::vector<double> x, std::vector<double> z) {
    Probe p;
    p.name = "p";
    p.kind = ProbeKind::pressure;
    p.sampling_frequency = 1000.0;
    p.x = std::move(x);
    p.z = std::move(z);
    return p;
}

std::vector<double> hydrostatic(const Water& water) {
    std::vector<double> pressure;
    for (const double z : water.particles.position[1]) pressure.push_back(weight * (0.04 - z));
    return pressure;
}

std::vector<double> read(const Water& water, const Probe& probe, const std::vector<double>& pressure,
                         const char* record) {
    const auto instrument = make_instrument(probe, water.parameters);
    EXPECT_TRUE(instrument->needs_fields());
    const FluidViewIn<2> fluid = water.view();
    const WorkingValues values = test::working(pressure);
    instrument->sample({.mass = water.particles.mass, .fluid = &fluid, .pressure = &values});
    return values_of(*instrument, record);
}

TEST(PressureGauges, ReadTheHydrostaticPressureOnBedAndWallsAndInTheWater) {
    const Water water(tank(), 0.3);
    const Probe p = gauges({0.05, 0.0, 0.1, 0.1, 0.05}, {0.0, 0.0, 0.003, 0.03, 0.02});
    const std::vector<double> pressure = read(water, p, hydrostatic(water), "pressure");
    const std::vector<double> share = read(water, p, hydrostatic(water), "wet_share");
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        EXPECT_NEAR(pressure[i], weight * (0.04 - p.z[i]), 1e-4 * weight * 0.04) << i;  // single precision
    }
    EXPECT_NEAR(share[0], 0.5, 0.05);
    EXPECT_NEAR(share[1], 0.25, 0.05);
    EXPECT_NEAR(share[4], 1.0, 0.05);
}

TEST(PressureGauges, ReadNothingWhereTheyAreDry) {
    const Water water(tank());
    const Probe p = gauges({0.1}, {0.05, 0.09});
    EXPECT_EQ(read(water, p, hydrostatic(water), "pressure"), (std::vector<double>{0.0, 0.0}));
    EXPECT_EQ(read(water, p, hydrostatic(water), "wet_share"), (std::vector<double>{0.0, 0.0}));
}

TEST(PressureGauges, OfASingleDropReadThePartThatItCovers) {
    // One particle on the wall under 1000 Pa: its kernel fills a small share of the gauge's support.
    Water water(tank());
    water.particles.resize(1);
    water.particles.position = {std::vector<double>{0.099}, std::vector<double>{0.08}};
    const Probe p = gauges({0.1}, {0.08, 0.086});
    const std::vector<double> pressure = read(water, p, {1000.0}, "pressure");
    const std::vector<double> share = read(water, p, {1000.0}, "wet_share");
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_GT(share[i], 0.0);
        EXPECT_LT(share[i], 0.15);
    }
    EXPECT_LT(share[1], least_wet_share);
    // The second gauge stands 6 mm higher.
    EXPECT_NEAR(pressure[1], (1000.0 - weight * 0.006) * share[1] / least_wet_share, 1e-4 * pressure[1]);
    EXPECT_LT(pressure[1], pressure[0]);
}

/// The same tank with a solid in the water, and a gauge on its upstream face, half-way up.
Case tank_with_solid() {
    Case c = tank();
    Solid solid;
    solid.name = "block";
    solid.x = {0.05, 0.07, 0.07, 0.05};
    solid.z = {0.01, 0.01, 0.03, 0.03};
    c.solids = {solid};
    return c;
}

TEST(PressureGauges, OnASolidReadALinearPressureThere) {
    // A kernel mean would give the pressure half a smoothing length before the face.
    const Water water(tank_with_solid(), 0.3);
    std::vector<double> pressure;
    for (std::size_t i = 0; i < water.particles.size(); ++i) {
        pressure.push_back(50.0 + 9000.0 * water.particles.position[0][i] -
                           4000.0 * water.particles.position[1][i]);
    }
    Probe p = gauges({0.0485, 0.06}, {0.02, 0.0305});  // beside the faces by less than a spacing
    p.solid = "block";
    const auto at = [](double x, double z) { return 50.0 + 9000.0 * x - 4000.0 * z; };
    for (const double diameter : {0.0, 0.008}) {
        p.diameter = diameter;
        const auto read_values = read(water, p, pressure, "pressure");
        EXPECT_NEAR(read_values[0], at(0.05, 0.02), 1e-4) << diameter;  // single precision
        EXPECT_NEAR(read_values[1], at(0.06, 0.03), 1e-4) << diameter;
        EXPECT_NEAR(make_instrument(p, water.parameters)->axes()[0].values[0], 0.05, 1e-12);
    }
}

TEST(PressureGauges, OnASolidMoveWithIt) {
    const Water water(tank_with_solid(), 0.3);
    std::vector<double> pressure;
    for (const double x : water.particles.position[0]) pressure.push_back(1000.0 * x);
    Probe p = gauges({0.05}, {0.02});
    p.solid = "block";
    const auto instrument = make_instrument(p, water.parameters);
    std::vector<BodyState> bodies(first_solid + 1);
    bodies[first_solid].displacement = {-0.012, 0.0, 0.003};
    const FluidViewIn<2> fluid = water.view();
    const WorkingValues values = test::working(pressure);
    instrument->sample(
        {.mass = water.particles.mass, .fluid = &fluid, .pressure = &values, .bodies = bodies});
    EXPECT_NEAR(values_of(*instrument, "pressure")[0], 1000.0 * 0.038, 1e-4);
}

TEST(PressureGauges, WithAFaceReadItsMean) {
    // Under a pressure with a square in it the mean over a face of width d is d^2/12 of it above the middle.
    const Water water(tank(), 0.0);
    std::vector<double> pressure;
    for (const double x : water.particles.position[0]) pressure.push_back(1e6 * (x - 0.05) * (x - 0.05));
    Probe p = gauges({0.05}, {0.0});
    const double point = read(water, p, pressure, "pressure")[0];
    p.diameter = 0.03;
    EXPECT_NEAR(read(water, p, pressure, "pressure")[0] - point, 1e6 * 0.03 * 0.03 / 12.0, 0.02 * 75.0);
}

}  // namespace
}  // namespace riffle::pressure_gauge_test
