#include <gtest/gtest.h>

#include <cmath>

#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "small_case.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/series.hpp"
#include "solver/summary.hpp"

namespace riffle::sampling_test {
namespace {

using test::Channel;
using test::small_channel;

TEST(Series, OfTheStartIsTheColumns) {
    Case c = small_channel();
    c.numerics.spacing = 0.002;  // five rows below the crest carry the drag
    c.start.perturbation = 0.0;
    const Channel channel(c);
    channel.advance(1);
    TimeSeries series(channel.parameters);
    series.sample(*channel.simulation, channel.parameters.total_depth());
    EXPECT_NEAR(series.last(fields::time_series.total_mean_velocity), channel.column.total_mean_velocity,
                0.01 * channel.column.total_mean_velocity);
    EXPECT_NEAR(series.last(fields::time_series.particle_order), 1.0, 1e-3);
    EXPECT_NEAR(series.last(fields::time_series.drag_over_gravity), 1.0, 0.03);
    // The budget of each row closes: weight = drag + wall + acceleration.
    EXPECT_NEAR(series.last(fields::time_series.drag_over_gravity) +
                    series.last(fields::time_series.wall_over_gravity) +
                    series.last(fields::time_series.acceleration_over_gravity),
                1.0, 0.01);
}

TEST(Profiles, OfTheStartFollowTheColumnAndTheStressLine) {
    Case c = small_channel();
    c.start.perturbation = 0.0;
    const Channel channel(c);
    ProfileSampler sampler(channel.parameters, &channel.column);
    while (sampler.blocks().size() < 3) {
        channel.advance(1);
        sampler.sample(*channel.simulation);
    }
    const Profiles p = sampler.average(0.0, 1.0);
    ASSERT_FALSE(p.empty());
    ASSERT_EQ(p.z.size(), 14U);
    EXPECT_NEAR(p.window_end - p.window_start, 0.3, 1e-6);
    const double crest_stress = 1000.0 * channel.parameters.streamwise_gravity() *
                                (channel.parameters.total_depth() - channel.parameters.crest());
    for (std::size_t k = 0; k + 4 < p.z.size(); ++k) {
        if (p.bin_lower[k] < channel.parameters.crest()) {
            continue;  // at 4 mm the roughness zone has two rows only
        }
        EXPECT_NEAR(p.velocity[k], channel.column.velocity_at(p.z[k]),
                    0.03 * channel.column.surface_velocity);
        EXPECT_NEAR(p.total_stress[k], p.analytic_stress[k], 0.1 * crest_stress)
            << "at z = " << p.bin_upper[k];
        EXPECT_NEAR(p.pressure[k], 1000.0 * 9.81 * (channel.parameters.total_depth() - p.z[k]),
                    0.03 * 1000.0 * 9.81 * channel.parameters.total_depth());
    }
}

/// Laminar flow between two plates at which the water rests.
Case plates() {
    Case c = small_channel();
    c.bed.kind = BedKind::no_slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.channel.top = Top::wall;
    c.turbulence.closure = ClosureKind::none;
    c.fluid.kinematic_viscosity = 1e-3;
    c.numerics.spacing = 0.002;
    return c;
}

// A wall above takes as much as the bed: the stress on planes passes through nothing halfway between them.
TEST(Profiles, BetweenTwoPlatesTheStressIsThatOfTheGradient) {
    const Channel channel(plates());
    const Case& c = channel.parameters;
    ProfileSampler sampler(c, &channel.column);
    while (sampler.blocks().size() < 2) {
        channel.advance(1);
        sampler.sample(*channel.simulation);
    }
    const Profiles p = sampler.average(0.0, 1.0);
    const double at_bed = 0.5 * 1000.0 * c.streamwise_gravity() * c.total_depth();
    ASSERT_EQ(p.total_stress.size(), p.z.size());
    for (std::size_t k = 0; k < p.z.size(); ++k) {
        const double exact = at_bed * (1.0 - 2.0 * p.bin_upper[k] / c.total_depth());
        EXPECT_NEAR(p.total_stress[k], exact, 0.03 * at_bed) << p.bin_upper[k];
        EXPECT_NEAR(p.analytic_stress[k], exact, 0.01 * at_bed) << p.bin_upper[k];
    }
    const auto line = fit_stress_line(c, p);
    ASSERT_TRUE(line.has_value());
    EXPECT_NEAR(line->crest_stress, at_bed, 0.03 * at_bed);
}

TEST(StressLine, EndsAtAWallAboveWithWhatItTakes) {
    const Case c = plates();
    std::vector<double> height;
    std::vector<double> stress;
    for (int k = 1; k <= 20; ++k) {
        height.push_back(0.05 * k * c.total_depth());
        stress.push_back(3.0 - 0.25 * k);  // 3 at the bed, -2 at the wall above
    }
    const auto line = fit_stress_line(c, height, stress);
    ASSERT_TRUE(line.has_value());
    EXPECT_NEAR(line->crest_stress, 3.0, 1e-9);
    EXPECT_NEAR(line->half_width, 0.0, 1e-9);
}

// Side walls at which the water rests take their part, and what drives the water between open ends is the
// difference of their pressures as well.
TEST(StressLine, IsNoneWhereMoreThanTheBedHoldsTheWater) {
    const std::vector<double> height{0.01, 0.015, 0.02, 0.025, 0.03, 0.035, 0.04, 0.045, 0.05, 0.055};
    const std::vector<double> stress{5.0, 4.5, 4.0, 3.5, 3.0, 2.5, 2.0, 1.5, 1.0, 0.5};
    Case c = small_channel();
    EXPECT_TRUE(fit_stress_line(c, height, stress).has_value());
    c.channel.ends = Ends::open;
    EXPECT_FALSE(fit_stress_line(c, height, stress).has_value());
    Case walls = plates();
    walls.channel.top = Top::free_surface;
    EXPECT_TRUE(fit_stress_line(walls, height, stress).has_value());
    walls.channel.dimensions = 3;
    walls.channel.sides = Sides::walls;
    EXPECT_FALSE(fit_stress_line(walls, height, stress).has_value());
}

// Water 80 mm deep where the case has 56: the bed takes 0.9 of its weight.
TEST(FrictionVelocity, BetweenOpenEndsIsThatOfTheBedsForce) {
    Case c = small_channel();
    c.channel.ends = Ends::open;
    const std::vector<double> share{0.8, 1.0};
    const std::vector<double> none{0.0, 0.0};
    const std::vector<double> volume(2, 0.08 * c.channel.length);
    EXPECT_NEAR(*bed_stress_of_weight(c, share, volume), 0.9 * 1000.0 * c.streamwise_gravity() * 0.08, 1e-9);
    const double depth = 0.08 - c.crest();
    EXPECT_NEAR(*open_friction_velocity(c, share, none, volume),
                std::sqrt(0.9 * c.streamwise_gravity() * depth), 1e-9);
    c.channel.ends = Ends::periodic;
    EXPECT_FALSE(open_friction_velocity(c, share, none, volume).has_value());
}

TEST(Profiles, OfAWindowWithoutBlocksAreEmpty) {
    const Channel channel(small_channel());
    const ProfileSampler sampler(channel.parameters, &channel.column);
    EXPECT_TRUE(sampler.average(0.0, 100.0).empty());
}

TEST(Profiles, OfRestoredBlocksAreTheSame) {
    const Channel channel(small_channel());
    ProfileSampler sampler(channel.parameters, &channel.column);
    while (sampler.blocks().size() < 2) {
        channel.advance(1);
        sampler.sample(*channel.simulation);
    }
    ProfileSampler restored(channel.parameters, &channel.column);
    restored.restore(sampler.blocks(), sampler.current());
    EXPECT_EQ(restored.average(0.0, 1.0).velocity, sampler.average(0.0, 1.0).velocity);
    EXPECT_EQ(restored.average(0.0, 1.0).total_stress, sampler.average(0.0, 1.0).total_stress);
}

TEST(Summary, KnowsWhatItWasNotGiven) {
    Numbers summary;
    const Field& friction_velocity = fields::summary.friction_velocity;
    EXPECT_TRUE(std::isnan(summary.value(friction_velocity)));
    summary.set(friction_velocity, 0.04);
    summary.set(friction_velocity, 0.05);
    EXPECT_DOUBLE_EQ(summary.value(friction_velocity), 0.05);
    EXPECT_EQ(summary.all().size(), 1U);
}

}  // namespace
}  // namespace riffle::sampling_test
