// What a simulation must keep with the options that are sums beside the pair loops, and with other walls.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "base/parallel.hpp"
#include "saved_state.hpp"
#include "small_case.hpp"

namespace riffle::method_options_test {
namespace {

using test::Channel;
using test::expect_same_bits;
using test::small_channel;

struct MethodOption {
    std::string name;
    std::function<void(Case&)> choose;
};

void stand_between_end_walls(Case& c) {
    c.channel.ends = Ends::walls;
    c.channel.slope = 0.0;
    c.channel.length = 0.1;
    c.start.kind = StartKind::rest;
}

Case case_of(const MethodOption& option) {
    Case c = small_channel();
    c.start.jitter = 0.2;
    option.choose(c);
    return c;
}

class MethodOptions : public testing::TestWithParam<MethodOption> {};

TEST_P(MethodOptions, GiveTheSameBitsForAnyNumberOfThreads) {
    const auto state_after = [](int threads) {
        set_thread_count(threads);
        const Channel channel(case_of(GetParam()));
        channel.advance(60);
        EXPECT_GT(channel.simulation->clock().list_builds, 1);
        set_thread_count(0);
        return channel.simulation->particles();
    };
    expect_same_bits(state_after(1), state_after(3));
}

TEST_P(MethodOptions, GoOnFromARestoredStateWithTheSameBits) {
    const Case c = case_of(GetParam());
    const Channel straight(c);
    straight.advance(20);
    const auto earlier = straight.simulation->clock().list_builds;
    while (straight.simulation->clock().list_builds == earlier) straight.advance(1);
    straight.advance(1);
    const Channel resumed(c);
    resumed.simulation->restore(test::saved_particles(*straight.simulation), straight.simulation->clock(),
                                straight.simulation->wall_density_deviation());
    straight.advance(40);
    resumed.advance(40);
    expect_same_bits(straight.simulation->particles(), resumed.simulation->particles());
}

// Pairs of water cancel: the momentum along the channel changes by weight, drag and walls alone.
TEST_P(MethodOptions, KeepTheMomentumBudget) {
    const Channel channel(case_of(GetParam()));
    channel.advance(30);
    const auto momentum = [&] {
        double sum = 0.0;
        for (std::size_t i = 0; i < channel.simulation->particles().size(); ++i) {
            sum += channel.simulation->particles().mass[i] * channel.simulation->particles().velocity[0][i];
        }
        return sum;
    };
    double expected = momentum();
    double weight = 0.0;
    for (int step = 0; step < 30; ++step) {
        channel.simulation->step();
        const auto& p = channel.simulation->particles();
        const auto& f = channel.simulation->fields();
        const double dt = channel.simulation->clock().time_step;
        for (std::size_t i = 0; i < p.size(); ++i) {
            weight += dt * p.mass[i] * 0.004 * channel.simulation->scheme().normal_gravity;
            expected += dt * p.mass[i] *
                        (channel.simulation->scheme().streamwise_gravity + f.drag_acceleration_x[i] +
                         f.wall_acceleration_x[i]);
        }
    }
    EXPECT_NEAR(momentum(), expected, 1e-3 * weight) << "of the weight along a slope of 0.004";
}

INSTANTIATE_TEST_SUITE_P(
    Solver, MethodOptions,
    testing::Values(
        MethodOption{"antuono", [](Case& c) { c.numerics.density_diffusion = DensityDiffusion::antuono; }},
        MethodOption{"local_depth", [](Case& c) { c.turbulence.depth = ClosureDepth::local; }},
        MethodOption{"bed_by_roughness", [](Case& c) { test::lay_plane_bed(c, 0.002); }},
        MethodOption{"smooth_bed_in_local_depth",
                     [](Case& c) {
                         test::lay_plane_bed(c, 0.0);
                         c.turbulence.depth = ClosureDepth::local;
                     }},
        MethodOption{"kernel", [](Case& c) { c.numerics.kernel_correction = KernelCorrection::kernel; }},
        MethodOption{"monaghan_kos", [](Case& c) { c.numerics.step_rule = StepRule::monaghan_kos; }},
        MethodOption{"modified_dynamic", [](Case& c) { c.numerics.wall = WallKind::modified_dynamic; }},
        MethodOption{"modified_dynamic_tank",
                     [](Case& c) {
                         c.numerics.wall = WallKind::modified_dynamic;
                         stand_between_end_walls(c);
                     }},
        MethodOption{"modified_dynamic_symplectic",
                     [](Case& c) {
                         c.numerics.wall = WallKind::modified_dynamic;
                         c.numerics.stepping = Stepping::symplectic;
                         c.numerics.courant_number = 0.3;
                     }},
        MethodOption{"repulsive_tank",
                     [](Case& c) {
                         c.numerics.wall = WallKind::repulsive;
                         c.numerics.pressure_form = PressureForm::symmetric;
                         stand_between_end_walls(c);
                     }},
        MethodOption{"repulsive_symplectic",
                     [](Case& c) {
                         c.numerics.wall = WallKind::repulsive;
                         c.numerics.pressure_form = PressureForm::symmetric;
                         c.numerics.stepping = Stepping::symplectic;
                         c.numerics.courant_number = 0.3;
                     }}),
    [](const auto& instance) { return instance.param.name; });

// In three dimensions the nodes stand in front of the bed and the side walls.
TEST(MethodOptionsInSpace, WallsByGhostNodesKeepTheFlow) {
    Case c = small_channel(3);
    c.channel.sides = Sides::walls;
    c.numerics.wall = WallKind::modified_dynamic;
    const test::ChannelIn<3> channel(c);
    channel.advance(100);
    const auto& p = channel.simulation->particles();
    double u = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        u += p.velocity[0][i] / static_cast<double>(p.size());
        EXPECT_GT(p.position[1][i], 0.0);
        EXPECT_LT(p.position[1][i], c.channel.width);
        EXPECT_GT(p.position[2][i], 0.0);
    }
    EXPECT_NEAR(u, channel.column.total_mean_velocity, 0.1 * channel.column.total_mean_velocity);
}

}  // namespace
}  // namespace riffle::method_options_test
