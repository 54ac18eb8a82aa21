#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "saved_state.hpp"
#include "small_case.hpp"

namespace riffle::simulation_test {
namespace {

using test::Channel;
using test::expect_same_bits;
using test::small_channel;
using testing::HasSubstr;

TEST(Simulation, GivesTheSameBitsForAnyNumberOfThreads) {
    Case c = small_channel();
    c.start.jitter = 0.2;
    set_thread_count(1);
    const Channel one(c);
    one.advance(300);
    set_thread_count(2);
    const Channel two(c);
    two.advance(300);
    set_thread_count(0);
    expect_same_bits(one.simulation->particles(), two.simulation->particles());
}

TEST(Simulation, GoesOnFromARestoredStateWithTheSameBits) {
    Case c = small_channel();
    c.start.jitter = 0.2;
    const Channel straight(c);
    straight.advance(137);  // between two list builds
    const Particles<2> saved = test::saved_particles(*straight.simulation);
    const SimulationClock clock = straight.simulation->clock();
    const auto walls = straight.simulation->wall_density_deviation();
    const Channel resumed(c);
    resumed.simulation->restore(saved, clock, walls);
    straight.advance(200);
    resumed.advance(200);
    expect_same_bits(straight.simulation->particles(), resumed.simulation->particles());
    EXPECT_EQ(straight.simulation->clock().time, resumed.simulation->clock().time);
}

TEST(Simulation, NamesTheParticleAndPlaceOfANotANumber) {
    const Channel channel(small_channel());
    channel.advance(10);
    Particles<2> damaged = channel.simulation->particles();
    damaged.velocity[0][42] = std::numeric_limits<double>::quiet_NaN();
    const auto id = std::to_string(damaged.id[42]);
    try {
        channel.simulation->restore(damaged, channel.simulation->clock(),
                                    channel.simulation->wall_density_deviation());
        FAIL() << "a NaN was accepted";
    } catch (const RunError& e) {
        EXPECT_THAT(e.what(), HasSubstr("no longer finite"));
        EXPECT_THAT(e.what(), HasSubstr("particle " + id));
        EXPECT_THAT(e.what(), HasSubstr("x = "));
        EXPECT_THAT(e.what(), HasSubstr("t = "));
    }
}

TEST(Simulation, StopsWhenAStepBlowsUp) {
    Case c = small_channel();
    c.numerics.time_step = 0.02;  // some 40 times the stable step
    const Channel channel(c);
    EXPECT_THROW(channel.advance(200), RunError);
}

TEST(Simulation, NamesAParticleThatLeftTheDomain) {
    const Channel channel(small_channel());
    Particles<2> lost = channel.simulation->particles();
    lost.position[1][7] = 10.0;
    try {
        channel.simulation->restore(lost, channel.simulation->clock(),
                                    channel.simulation->wall_density_deviation());
        FAIL() << "a particle 10 m above the bed was accepted";
    } catch (const RunError& e) {
        EXPECT_THAT(e.what(), HasSubstr("left the domain"));
    }
}

// Pair forces cancel, so the streamwise momentum changes by weight, drag and walls alone.
TEST(Simulation, KeepsTheMomentumBudget) {
    Case c = small_channel();
    c.start.jitter = 0.2;
    const Channel channel(c);
    channel.advance(50);
    const auto momentum = [&] {
        const auto& p = channel.simulation->particles();
        return std::inner_product(p.mass.begin(), p.mass.end(), p.velocity[0].begin(), 0.0);
    };
    double weight = 0.0;
    double impulse = 0.0;
    const double before = momentum();
    for (int i = 0; i < 100; ++i) {
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
    EXPECT_NEAR(momentum() - before, weight + impulse, 1e-3 * weight);
}

TEST(Simulation, KeepsEveryParticleAndItsMass) {
    const Channel channel(small_channel());
    const auto mass = [&] {
        const auto& m = channel.simulation->particles().mass;
        return std::accumulate(m.begin(), m.end(), 0.0);
    };
    const std::size_t n = channel.simulation->particles().size();
    const double before = mass();
    channel.advance(400);
    auto ids = channel.simulation->particles().id;
    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(ids.size(), n);
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(ids[i], static_cast<std::int64_t>(i));
    EXPECT_NEAR(mass(), before, 1e-12 * before);
}

/// Each optional method at least runs, stays near the column for a moment and keeps the level.
class Options : public testing::TestWithParam<std::pair<const char*, void (*)(Case&)>> {};

TEST_P(Options, CarryTheFlow) {
    Case c = small_channel();
    GetParam().second(c);
    const Channel channel(c);
    channel.advance(200);
    test::expect_carried_flow(channel, 0.05);
}

INSTANTIATE_TEST_SUITE_P(
    Methods, Options,
    testing::Values(
        std::pair{"double_precision", +[](Case& c) { c.numerics.precision = Precision::double_precision; }},
        std::pair{"cubic_spline", +[](Case& c) { c.numerics.kernel = KernelKind::cubic_spline; }},
        std::pair{"symmetric_pressure", +[](Case& c) { c.numerics.pressure_form = PressureForm::symmetric; }},
        std::pair{"plain_gradient", +[](Case& c) { c.numerics.velocity_gradient = VelocityGradient::plain; }},
        std::pair{"tait", +[](Case& c) { c.numerics.equation_of_state = EquationOfState::tait; }},
        std::pair{"stress_divergence",
                  +[](Case& c) { c.numerics.eddy_stress = EddyStress::stress_divergence; }},
        std::pair{"monaghan_gingold",
                  +[](Case& c) { c.numerics.viscosity = ViscosityForm::monaghan_gingold; }},
        std::pair{"predictor_corrector",
                  +[](Case& c) {
                      c.numerics.stepping = Stepping::predictor_corrector;
                      c.numerics.courant_number = 0.2;
                  }},
        std::pair{"shepard", +[](Case& c) { c.numerics.density_filter = DensityFilter::shepard; }},
        std::pair{"mls", +[](Case& c) { c.numerics.density_filter = DensityFilter::mls; }},
        std::pair{"xsph",
                  +[](Case& c) {
                      c.numerics.stepping = Stepping::semi_implicit_euler;
                      c.numerics.xsph = 0.3;
                  }},
        std::pair{"dynamic_wall",
                  +[](Case& c) {
                      c.numerics.wall = WallKind::dynamic;
                      c.numerics.wall_layers = 2;
                  }},
        std::pair{"paper_drag", +[](Case& c) { c.bed.drag_form = DragForm::paper; }},
        std::pair{"thesis_drag", +[](Case& c) { c.bed.drag_form = DragForm::thesis; }},
        std::pair{"nezu_rodi", +[](Case& c) { c.turbulence.closure = ClosureKind::nezu_rodi; }},
        std::pair{"nikuradse", +[](Case& c) { c.turbulence.closure = ClosureKind::nikuradse; }}),
    [](const auto& instance) { return std::string(instance.param.first); });

// Below a wall at the top there are no waves whose speed would tell, and still water has none.
TEST(SpeedOfSound, IsThereForWaterThatNothingMoves) {
    Case c = test::still_water();
    c.channel.top = Top::wall;
    EXPECT_NEAR(make_scheme(c, nullptr).state.sound_speed, 10.0 * std::sqrt(9.81 * c.total_depth()), 1e-3);
    c.fluid.gravity = 0.0;
    try {
        static_cast<void>(make_scheme(c, nullptr));
        ADD_FAILURE() << "no speed of sound follows";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("numerics.sound_speed"));
    }
}

}  // namespace
}  // namespace riffle::simulation_test
