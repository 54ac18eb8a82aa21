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
