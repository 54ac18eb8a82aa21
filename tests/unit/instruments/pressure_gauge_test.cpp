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
    for (const double z : water.particles.position[1]) {
        pressure.push_back(weight * (0.04 - z));
    }
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

}  // namespace
}  // namespace riffle::pressure_gauge_test
