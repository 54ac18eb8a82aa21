// The depth that the mixing lengths follow, and their limit beside solids; beds by a wall law in space.

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "base/parallel.hpp"
#include "boundary/solid_distance.hpp"
#include "case/flow_kind.hpp"
#include "same_bits.hpp"
#include "small_case.hpp"

namespace riffle::local_depth_test {
namespace {

using test::ChannelIn;
using test::expect_same_bits;
using test::small_channel;

template <int D>
const std::vector<double>& depths(const ChannelIn<D>& channel) {
    for (const FurtherField& field : channel.simulation->particles().further) {
        if (field.info.name == "closure_depth") return field.values;
    }
    throw std::runtime_error("the particles have no depth");
}

Case with_body() {
    Case c = small_channel();
    c.channel.length = 0.2;
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.3;
    Solid block;
    block.name = "block";
    block.x = {0.08, 0.12, 0.12, 0.08};
    block.z = {0.0, 0.0, 0.02, 0.02};
    c.solids.push_back(block);
    return c;
}

TEST(LocalDepth, IsForFlowThatVariesAlongTheChannel) {
    EXPECT_FALSE(uses_local_depth(small_channel()));
    EXPECT_TRUE(uses_local_depth(with_body()));
    Case c = small_channel();
    c.turbulence.depth = ClosureDepth::local;
    EXPECT_TRUE(uses_local_depth(c));
    c = with_body();
    c.turbulence.depth = ClosureDepth::initial;
    EXPECT_FALSE(uses_local_depth(c));
    c = with_body();
    c.turbulence.closure = ClosureKind::none;
    EXPECT_FALSE(uses_local_depth(c));
}

template <int D>
void expect_depth_of_uniform_flow() {
    Case c = small_channel(D);
    c.turbulence.depth = ClosureDepth::local;
    const ChannelIn<D> channel(c);
    channel.advance(40);
    for (const double depth : depths(channel)) {
        EXPECT_NEAR(depth, c.total_depth(), 0.005 * c.total_depth());  // the bar of the level
    }
}

TEST(LocalDepth, IsThatOfUniformFlow) {
    expect_depth_of_uniform_flow<2>();
    expect_depth_of_uniform_flow<3>();
}

TEST(LocalDepth, FollowsTheWaterAlongTheChannel) {
    Case c = small_channel();
    c.channel.length = 0.4;
    c.channel.slope = 0.0;
    c.turbulence.depth = ClosureDepth::local;
    c.start.kind = StartKind::rest;
    c.start.water_x = {0.0, 0.4, 0.4, 0.0};
    c.start.water_z = {0.0, 0.0, 0.072, 0.04};
    const ChannelIn<2> channel(c);
    channel.advance(1);
    const auto& particles = channel.simulation->particles();
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double x = particles.position[0][i];
        if (x > 0.06 && x < 0.34) {  // away from the jump at the periodic ends
            EXPECT_NEAR(depths(channel)[i], 0.04 + 0.08 * x, 0.5 * c.numerics.spacing) << x;
        }
    }
}

TEST(LocalDepth, BesideABodyHasTheSameBitsForAnyThreadsAndAfterResume) {
    const auto state_after = [](int threads) {
        set_thread_count(threads);
        const ChannelIn<2> channel(with_body());
        channel.advance(60);
        set_thread_count(0);
        return channel.simulation->particles();
    };
    expect_same_bits(state_after(1), state_after(3));
    test::expect_same_bits_after_resume(with_body(), 21, 40);  // saved between two looks at the depth
}

TEST(SolidDistance, IsThatFromTheOutlineAndZeroInside) {
    const Case c = with_body();
    const SolidDistance<2> distance(c, 0.03);
    EXPECT_EQ(distance.at({}, {0.1, 0.01}), 0.0);
    EXPECT_NEAR(distance.at({}, {0.1, 0.032}), 0.012, 0.05 * c.numerics.spacing);
    EXPECT_NEAR(distance.at({}, {0.14, 0.008}), 0.02, 0.05 * c.numerics.spacing);
    EXPECT_EQ(distance.at({}, {0.02, 0.01}), 0.03);
    // Through the periodic ends.
    EXPECT_NEAR(distance.at({}, {0.1 - 0.2, 0.032}), 0.012, 0.05 * c.numerics.spacing);
    // Of a body that has moved.
    std::vector<BodyState> bodies(3);
    bodies[2].displacement = {0.05, 0.0, 0.0};
    EXPECT_NEAR(distance.at(bodies, {0.15, 0.032}), 0.012, 0.05 * c.numerics.spacing);
}

TEST(BedByRoughnessInSpace, HoldsTheFlowAndTheBits) {
    Case c = small_channel(3);
    test::lay_plane_bed(c, 0.002);
    const auto state_after = [&c](int threads) {
        set_thread_count(threads);
        const ChannelIn<3> channel(c);
        channel.advance(40);
        set_thread_count(0);
        return channel.simulation->particles();
    };
    const Particles<3> particles = state_after(1);
    expect_same_bits(particles, state_after(3));
    double mean = 0.0;
    for (const double u : particles.velocity[0]) mean += u / static_cast<double>(particles.size());
    const double twin = solve_column(c).total_mean_velocity;
    EXPECT_NEAR(mean, twin, 0.01 * twin);
}

}  // namespace
}  // namespace riffle::local_depth_test
