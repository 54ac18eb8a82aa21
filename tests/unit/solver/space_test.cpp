// What a simulation in three dimensions must keep; simulation_test.cpp does the same for two.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "particles/lattice.hpp"
#include "saved_state.hpp"
#include "small_case.hpp"

namespace riffle::space_test {
namespace {

using test::expect_same_bits;
using test::small_channel;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using Space = test::ChannelIn<3>;

Case disordered_channel() {
    Case c = small_channel(3);
    c.start.jitter = 0.2;
    return c;
}

// A standing wave and a hexagonal lattice start in space as they do in a plane, the same in each file.
TEST(Space, StartsFlowsOfThePlaneInEachFile) {
    for (const StartLattice lattice : {StartLattice::square, StartLattice::hexagonal}) {
        Case c = test::still_water(2);
        c.start.kind = StartKind::standing_wave;
        c.start.amplitude = 0.002;
        c.start.lattice = lattice;
        const Particles<2> plane = initial_particles<2>(c, make_scheme(c, nullptr), nullptr);
        c.channel.dimensions = 3;
        c.channel.width = 0.028;
        const Particles<3> space = initial_particles<3>(c, make_scheme(c, nullptr), nullptr);
        const Lattice places = lattice_of(c);
        const auto files = static_cast<std::size_t>(places.files);
        const auto rows = static_cast<std::size_t>(places.rows);
        ASSERT_EQ(space.size(), files * plane.size());
        double wave = 0.0;
        for (std::size_t i = 0; i < space.size(); ++i) {
            // Column by column, in each file by file, in each row by row.
            const std::size_t same = i / (files * rows) * rows + i % rows;
            ASSERT_EQ(space.position[0][i], plane.position[0][same]);
            ASSERT_EQ(space.position[2][i], plane.position[1][same]);
            ASSERT_EQ(space.density_deviation[i], plane.density_deviation[same]);
            wave = std::max(wave, space.position[2][i]);
        }
        EXPECT_GT(wave, c.total_depth() - 0.5 * places.dz + 0.0015);
    }
}

TEST(Space, GivesTheSameBitsForAnyNumberOfThreads) {
    const auto state_after = [](int threads) {
        set_thread_count(threads);
        const Space channel(disordered_channel());
        channel.advance(60);
        EXPECT_GT(channel.simulation->clock().list_builds, 2);
        set_thread_count(0);
        return channel.simulation->particles();
    };
    const Particles<3> one = state_after(1);
    expect_same_bits(one, state_after(2));
    expect_same_bits(one, state_after(3));
}

TEST(Space, GoesOnFromARestoredStateWithTheSameBits) {
    const Case c = disordered_channel();
    const Space straight(c);
    // Saved between two list builds, so that the resumed run has to build the lists of earlier positions.
    straight.advance(20);
    const auto earlier = straight.simulation->clock().list_builds;
    while (straight.simulation->clock().list_builds == earlier) straight.advance(1);
    const auto builds = straight.simulation->clock().list_builds;
    const Particles<3> saved = test::saved_particles(*straight.simulation);
    const SimulationClock clock = straight.simulation->clock();
    const auto walls = straight.simulation->wall_density_deviation();
    straight.advance(1);
    ASSERT_EQ(straight.simulation->clock().list_builds, builds);
    const Space resumed(c);
    resumed.simulation->restore(saved, clock, walls);
    resumed.advance(1);
    straight.advance(60);
    resumed.advance(60);
    EXPECT_GT(straight.simulation->clock().list_builds, builds + 2);
    EXPECT_EQ(straight.simulation->clock().list_builds, resumed.simulation->clock().list_builds);
    expect_same_bits(straight.simulation->particles(), resumed.simulation->particles());
    EXPECT_EQ(straight.simulation->clock().time, resumed.simulation->clock().time);
}

// Pair forces cancel, so the streamwise momentum changes by weight, drag and walls alone, and the momentum
// across, which nothing drives, hardly at all.
TEST(Space, KeepsTheMomentumBudget) {
    const Space channel(disordered_channel());
    channel.advance(30);
    const auto momentum = [&](std::size_t axis) {
        const auto& p = channel.simulation->particles();
        return std::inner_product(p.mass.begin(), p.mass.end(), p.velocity[axis].begin(), 0.0);
    };
    double weight = 0.0;
    double impulse = 0.0;
    const double before = momentum(0);
    const double before_across = momentum(1);
    for (int i = 0; i < 50; ++i) {
        channel.advance(1);
        const auto& p = channel.simulation->particles();
        const auto& f = channel.simulation->fields();
        const double dt = channel.simulation->clock().time_step;
        for (std::size_t k = 0; k < p.size(); ++k) {
            weight += dt * p.mass[k] * channel.simulation->scheme().streamwise_gravity;
            impulse += dt * p.mass[k] * (f.drag_acceleration_x[k] + f.wall_acceleration_x[k]);
        }
    }
    // Single-precision pair sums: 1e-3 of the weight is the bar of the budget identity.
    EXPECT_NEAR(momentum(0) - before, weight + impulse, 1e-3 * weight);
    // The disordered water and the rows of the bed push at each other a little, at random: far less than the
    // weight, which would show at once if the momentum leaked from x to y.
    EXPECT_NEAR(momentum(1), before_across, 0.05 * weight);
}

TEST(Space, KeepsEveryParticleAndItsMass) {
    const Space channel(disordered_channel());
    const std::vector<double> mass = channel.simulation->particles().mass;
    const auto before = test::places_by_id<3>(channel.simulation->particles());
    channel.advance(80);
    const Particles<3>& p = channel.simulation->particles();
    auto ids = p.id;
    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(ids.size(), mass.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        EXPECT_EQ(ids[i], static_cast<std::int64_t>(i));
        EXPECT_EQ(p.mass[i], mass[before[static_cast<std::size_t>(p.id[i])]]);
    }
}

Case still_water(int dimensions) {
    Case c = small_channel(dimensions);
    c.channel.slope = 0.0;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.fluid.kinematic_viscosity = 1e-4;
    c.turbulence.closure = ClosureKind::none;
    c.start.kind = StartKind::rest;
    return c;
}

/// Largest velocities by axis from `begin` to `end`, s, over sqrt(g H).
template <int D>
std::array<double, 3> largest_velocities(const Case& c, double begin, double end) {
    const auto simulation =
        make_simulation<D>(c, nullptr, initial_particles<D>(c, make_scheme(c, nullptr), nullptr));
    std::array<double, 3> largest{};
    while (simulation->clock().time < end) {
        simulation->step();
        for (std::size_t k = 0; k < D && simulation->clock().time > begin; ++k) {
            for (const double u : simulation->particles().velocity[k]) {
                largest[k] = std::max(largest[k], std::abs(u) / std::sqrt(c.fluid.gravity * c.total_depth()));
            }
        }
    }
    return largest;
}

// Nothing drives the water across but the rounding of the accelerations, 2e-5 g (precision_test.cpp), which
// 0.3 s of the same sign would turn into 1e-4 sqrt(gH), the bar of the verification. Along z the start
// settles, as in two dimensions: the rows under the surface come closer.
TEST(Space, StillWaterStaysAtRest) {
    const auto plane = largest_velocities<2>(still_water(2), 0.2, 0.3);
    const auto space = largest_velocities<3>(still_water(3), 0.2, 0.3);
    EXPECT_LT(space[0], 1e-4);
    EXPECT_LT(space[1], 1e-4);
    EXPECT_LT(plane[1], 5e-3);
    EXPECT_LT(space[2], 2.0 * plane[1]);
}

/// The message of what f throws.
template <class F>
std::string error_of(const F& f) {
    try {
        f();
    } catch (const RunError& e) {
        return e.what();
    }
    return "no error";
}

TEST(Space, NamesParticlePlaceAndTimeOfAFault) {
    const Space channel(small_channel(3));
    channel.advance(5);
    const auto& simulation = channel.simulation;
    const auto& walls = simulation->wall_density_deviation();
    const Particles<3> good = simulation->particles();
    const auto where = [&](std::size_t i) {
        return AllOf(HasSubstr("particle " + std::to_string(good.id[i]) + " "), HasSubstr("x = "),
                     HasSubstr("y = "), HasSubstr("z = "), HasSubstr("at t = "), HasSubstr("step 5"));
    };
    for (std::size_t k = 0; k < 3; ++k) {
        Particles<3> bad = good;
        bad.velocity[k][42] = std::numeric_limits<double>::quiet_NaN();
        EXPECT_THAT(error_of([&] { simulation->restore(bad, simulation->clock(), walls); }),
                    AllOf(HasSubstr("no longer finite"), where(42)));
    }
    // The domain of still water reaches one depth and the walls above the surface.
    Particles<3> bad = good;
    bad.position[2][7] = 10.0;
    EXPECT_THAT(error_of([&] { simulation->restore(bad, simulation->clock(), walls); }),
                AllOf(HasSubstr("left the domain"), HasSubstr("z = 10 m"), where(7)));
    // Two that leave it in a step: 1 mm below the top of the domain, 4 mm a step.
    const Case c = small_channel(3);
    bad = good;
    for (const std::size_t i : {std::size_t{11}, std::size_t{12}}) {
        bad.position[0][i] = 0.04 + c.numerics.spacing * static_cast<double>(i - 11);
        bad.position[1][i] = 0.5 * c.channel.width;
        bad.position[2][i] = 2.0 * c.total_depth() + (c.numerics.wall_layers + 1) * c.numerics.spacing - 1e-3;
        bad.velocity[2][i] = 10.0;
    }
    simulation->restore(bad, simulation->clock(), walls);
    EXPECT_THAT(error_of([&] { simulation->step(); }),
                AllOf(HasSubstr("left the domain"), AnyOf(where(11), where(12))));
    // The good state still runs.
    simulation->restore(good, simulation->clock(), walls);
    simulation->step();
    EXPECT_EQ(simulation->clock().steps, 6);
}

TEST(Space, StopsWhenAStepBlowsUp) {
    Case c = small_channel(3);
    c.numerics.time_step = 0.02;  // some 40 times the stable step
    const Space channel(c);
    EXPECT_THROW(channel.advance(200), RunError);
}

}  // namespace
}  // namespace riffle::space_test
