// The drag of stems on the particles: its size, its bounds, its books.

#include <gtest/gtest.h>

#include <cmath>

#include "record/flow_fields.hpp"
#include "same_bits.hpp"
#include "small_case.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/series.hpp"
#include "vegetated_channel.hpp"

namespace riffle::vegetation_test {
namespace {

using test::ChannelIn;

/// Stems through the whole depth over a bed that does not hold the water.
Case emergent(int dimensions = 2) {
    Case c = test::still_water(dimensions);
    c.channel.dimensions = dimensions;
    c.channel.slope = 0.004;
    c.turbulence.closure = ClosureKind::nezu_rodi;
    c.start.kind = StartKind::column;
    c.start.perturbation = 0.0;
    c.vegetation = {test::stems(400.0, 0.008, 0.1, 1.2)};
    return c;
}

Case patch(int dimensions = 2) {
    Case c = emergent(dimensions);
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.2;
    c.vegetation.front().x_from = 0.03;
    c.vegetation.front().x_to = 0.06;
    c.vegetation.front().height = 0.03;
    return c;
}

template <int D>
void expect_weight_on_stems() {
    const ChannelIn<D> channel(emergent(D));
    channel.advance(3);
    TimeSeries series(channel.parameters);
    series.sample(*channel.simulation, channel.parameters.total_depth());
    const auto& of = fields::time_series;
    EXPECT_NEAR(series.last(of.vegetation_over_gravity), 1.0, 1e-3);
    EXPECT_EQ(series.last(of.drag_over_gravity), 0.0);
    EXPECT_NEAR(series.last(of.vegetation_power), -series.last(of.gravity_power),
                1e-3 * series.last(of.gravity_power));
    EXPECT_EQ(series.last(of.further_power), 0.0);
    EXPECT_NEAR(series.last(of.vegetation_over_gravity) + series.last(of.wall_over_gravity) +
                    series.last(of.acceleration_over_gravity),
                1.0, 3e-5);
}

TEST(VegetationDrag, CarriesTheWeightOfAUniformFlow) {
    expect_weight_on_stems<2>();
    expect_weight_on_stems<3>();
}

TEST(VegetationDrag, BringsWaterToRestWithinAStepAtMost) {
    Case c = emergent();
    c.channel.slope = 0.0;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.2;
    // beta some 1e6 1/m: an explicit step would throw the water back.
    c.vegetation.front().stems_per_area = 2e4;
    c.vegetation.front().stem_diameter = 0.006;
    c.vegetation.front().drag_coefficient = 100.0;
    const ChannelIn<2> channel(c);
    channel.advance(20);
    for (const double u : channel.simulation->particles().velocity[0]) {
        EXPECT_GE(u, -1e-3);
        EXPECT_LT(u, 0.05);
    }
}

TEST(VegetationDrag, ActsInItsPatchAlone) {
    const ChannelIn<2> channel(patch());
    channel.advance(2);
    const auto& p = channel.simulation->particles();
    const auto& drag = channel.simulation->fields().vegetation_acceleration_x;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double x = p.position[0][i];
        const double z = p.position[1][i];
        if (x < 0.027 || x > 0.063 || z > 0.033) {
            EXPECT_EQ(drag[i], 0.0) << x << " " << z;
        } else if (x > 0.033 && x < 0.057 && z < 0.027) {
            EXPECT_LT(drag[i], 0.0) << x << " " << z;
        }
    }
}

TEST(VegetationDrag, HasTheSameBitsForAnyNumberOfThreads) {
    test::expect_same_bits_for_any_threads<2>(patch(2), 12);
    test::expect_same_bits_for_any_threads<3>(patch(3), 12);
}

TEST(VegetationDrag, HasTheSameBitsAfterResume) { test::expect_same_bits_after_resume(patch(), 21, 20); }

TEST(VegetationDrag, OfFlexibleStemsCarriesTheTwinsFlow) {
    Case c = emergent();
    c.vegetation.front().drag_coefficient.reset();
    c.vegetation.front().vogel_exponent = -0.8;
    c.vegetation.front().reference_velocity = 0.05;
    const ChannelIn<2> channel(c);
    channel.advance(50);
    test::expect_carried_flow(channel, 0.001);
}

TEST(VegetationDrag, ActsWithEveryMethodOfTimeStepping) {
    for (const Stepping stepping : {Stepping::semi_implicit_euler, Stepping::leapfrog, Stepping::verlet,
                                    Stepping::predictor_corrector, Stepping::symplectic, Stepping::beeman}) {
        Case c = emergent();
        c.numerics.stepping = stepping;
        c.numerics.courant_number = 0.2;
        const ChannelIn<2> channel(c);
        channel.advance(5);
        test::expect_carried_flow(channel, 0.005);
    }
}

}  // namespace
}  // namespace riffle::vegetation_test
