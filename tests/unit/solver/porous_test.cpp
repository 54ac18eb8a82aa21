// Water in porous zones: rest, discharge, resistance, the books.

#include <gtest/gtest.h>

#include <cmath>

#include "record/flow_fields.hpp"
#include "roughness/porous_resistance.hpp"
#include "same_bits.hpp"
#include "small_case.hpp"
#include "solver/series.hpp"

namespace riffle::porous_test {
namespace {

using test::ChannelIn;
using test::expect_same_bits;

Porous medium(double porosity, double permeability) {
    Porous zone;
    zone.name = "medium";
    zone.porosity = porosity;
    zone.permeability = permeability;
    return zone;
}

/// Water over a bed that does not hold it, with a zone.
Case with_zone(Porous zone, int dimensions = 2) {
    Case c = test::still_water(dimensions);
    c.channel.dimensions = dimensions;
    c.start.perturbation = 0.0;
    c.porous = {std::move(zone)};
    return c;
}

/// All of the water within the medium, on a slope.
Case filled(int dimensions = 2) {
    Case c = with_zone(medium(0.4, 1e-8), dimensions);
    c.channel.slope = 0.01;
    c.start.kind = StartKind::column;
    return c;
}

template <int D>
void expect_darcys_discharge() {
    const ChannelIn<D> channel(filled(D));
    channel.advance(30);
    const Case& c = channel.parameters;
    const double q =
        PorousResistance(c.porous.front(), c.fluid.kinematic_viscosity).discharge_at(c.streamwise_gravity());
    // The lowest row feels the particles of the bed a little: so slow a flow hardly slides over them.
    double mean = 0.0;
    const auto& velocity = channel.simulation->particles().velocity[0];
    for (const double u : velocity) {
        mean += u / static_cast<double>(velocity.size());
        EXPECT_NEAR(u, q / 0.4, 0.02 * q / 0.4);
    }
    EXPECT_NEAR(mean, q / 0.4, 2e-3 * q / 0.4);
    TimeSeries series(c);
    series.sample(*channel.simulation, c.total_depth());
    const auto& of = fields::time_series;
    EXPECT_NEAR(series.last(of.porous_over_gravity), 1.0, 3e-3);
    // It takes the sound of the start as well.
    EXPECT_NEAR(series.last(of.porous_power), -series.last(of.gravity_power),
                0.1 * series.last(of.gravity_power));
    EXPECT_NEAR(series.last(of.further_power), 0.0, 1e-9 * series.last(of.gravity_power));
}

TEST(PorousZones, PassDarcysDischargeUnderTheWeight) {
    expect_darcys_discharge<2>();
    expect_darcys_discharge<3>();
}

/// A resistance of 1e6 1/s: what an explicit step would multiply by some hundred.
TEST(PorousZones, HoldTheWaterHoweverTheyResist) {
    Case c = filled();
    c.porous.front().permeability = 1e-12;
    const ChannelIn<2> channel(c);
    channel.advance(30);
    const double q = c.streamwise_gravity() * 1e-12 / c.fluid.kinematic_viscosity;
    for (const double u : channel.simulation->particles().velocity[0]) EXPECT_NEAR(u, q / 0.4, 2e-3 * q);
}

/// Water at rest stays at rest at upright and level edges alike: no faster than without a zone.
TEST(PorousZones, LeaveWaterAtRest) {
    const auto fastest_with = [](double porosity) {
        Porous zone = medium(porosity, 1e-6);
        zone.x_from = 0.02;
        zone.x_to = 0.06;
        zone.z_to = 0.02;
        const ChannelIn<2> channel(with_zone(zone));
        channel.advance(200);
        double fastest = 0.0;
        const auto& p = channel.simulation->particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            fastest = std::max(fastest, std::hypot(p.velocity[0][i], p.velocity[1][i]));
        }
        return fastest;
    };
    const double without = fastest_with(1.0);
    for (const double porosity : {0.8, 0.4, 0.3}) {
        EXPECT_LT(fastest_with(porosity), 2.0 * without + 1e-3) << porosity;
    }
}

/// Grains that fill nothing and hold nothing back leave each bit as it is.
TEST(PorousZones, WithoutGrainsLeaveEachBit) {
    Porous zone = medium(1.0, 1.0);
    zone.permeability.reset();
    zone.grain_size = 0.01;  // no resistance where n = 1
    zone.x_from = 0.02;
    zone.x_to = 0.06;
    Case c = with_zone(zone);
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.2;
    Case without = c;
    without.porous.clear();
    const ChannelIn<2> with_it(c);
    const ChannelIn<2> without_it(without);
    with_it.advance(30);
    without_it.advance(30);
    expect_same_bits(with_it.simulation->particles(), without_it.simulation->particles());
}

Case patch(int dimensions = 2) {
    Porous zone = medium(0.5, 1e-7);
    zone.x_from = 0.02;
    zone.x_to = 0.06;
    Case c = with_zone(zone, dimensions);
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.05;
    return c;
}

TEST(PorousZones, HaveTheSameBitsForAnyNumberOfThreads) {
    test::expect_same_bits_for_any_threads<2>(patch(2), 12);
    test::expect_same_bits_for_any_threads<3>(patch(3), 12);
}

TEST(PorousZones, HaveTheSameBitsAfterResume) { test::expect_same_bits_after_resume(patch(), 21, 20); }

}  // namespace
}  // namespace riffle::porous_test
