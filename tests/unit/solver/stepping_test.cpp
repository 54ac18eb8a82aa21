#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "case/words.hpp"
#include "methods/stepper.hpp"
#include "small_case.hpp"
#include "solver/recorder.hpp"
#include "solver/state_content.hpp"
#include "written_checkpoint.hpp"

namespace riffle::stepping_test {
namespace {

using test::Channel;
using test::ChannelIn;
using test::expect_same_bits;
using test::small_channel;

Case stepped(Stepping stepping, int dimensions = 2) {
    Case c = small_channel(dimensions);
    c.numerics.stepping = stepping;
    c.numerics.courant_number = 0.2;
    return c;
}

/// The steppers that are not the default.
class Steppers : public testing::TestWithParam<Stepping> {};

TEST_P(Steppers, GiveTheSameBitsForAnyNumberOfThreads) {
    Case c = stepped(GetParam());
    c.start.jitter = 0.2;
    set_thread_count(1);
    const Channel one(c);
    one.advance(200);
    set_thread_count(2);
    const Channel two(c);
    two.advance(200);
    set_thread_count(0);
    expect_same_bits(one.simulation->particles(), two.simulation->particles());
}

/// Save at a step, load into a new simulation through the content of a checkpoint, and compare what follows.
template <int D>
void expect_resumable(const Case& c, int steps) {
    const ChannelIn<D> straight(c);
    straight.advance(steps);
    Content checkpoint;
    add_state<D>(checkpoint, *straight.simulation);
    const ChannelIn<D> resumed(c);
    restore_state<D>(test::WrittenCheckpoint(checkpoint).reader(), *resumed.simulation);
    straight.advance(60);
    resumed.advance(60);
    expect_same_bits(straight.simulation->particles(), resumed.simulation->particles());
    EXPECT_EQ(straight.simulation->clock().time, resumed.simulation->clock().time);
}

// 137 is between two list builds and between two Euler steps of Verlet's method. The filter restarts that
// method.
TEST_P(Steppers, GoOnFromACheckpointWithTheSameBits) {
    Case c = stepped(GetParam());
    c.start.jitter = 0.2;
    expect_resumable<2>(c, 137);
    c.numerics.density_filter = DensityFilter::shepard;
    expect_resumable<2>(c, 91);
    expect_resumable<3>(stepped(GetParam(), 3), 17);
}

TEST_P(Steppers, CarryTheFlow) {
    const Case c = stepped(GetParam());
    const Channel channel(c);
    channel.advance(600);
    test::expect_carried_flow(channel, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Methods, Steppers,
                         testing::Values(Stepping::semi_implicit_euler, Stepping::predictor_corrector,
                                         Stepping::verlet, Stepping::symplectic, Stepping::beeman),
                         [](const auto& instance) {
                             std::string name{word(instance.param)};
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

/// One particle on a spring, u' = -w^2 x, and a density that decays, s' = -rate (1 + s), stepped over a time
/// of one with steps whose lengths alternate; its errors.
struct SpringError {
    double position = 0.0;
    double velocity = 0.0;
    double density = 0.0;
};

SpringError spring_error(Stepping stepping, int steps, double unevenness) {
    constexpr double w = 2.0;
    constexpr double rate = 0.5;
    const auto stepper = make_stepper<2>(stepping);
    Particles<2> p;
    p.resize(1);
    stepper->declare(p);
    p.position[1][0] = 1.0;
    StepSize size;
    for (int n = 0; n < steps; ++n) {
        size.now = (1.0 + (n % 2 == 0 ? unevenness : -unevenness)) / steps;
        size.steps = n;
        stepper->begin(p, size);
        for (int evaluation = 0; evaluation < stepper->evaluations(); ++evaluation) {
            ParticleRates<2> rates{.density = -rate * (1.0 + p.density_deviation[0])};
            rates.acceleration[1] = -w * w * p.position[1][0];
            stepper->advance(evaluation, 0, rates, p);
        }
        size.before = size.now;
    }
    return {std::abs(p.position[1][0] - std::cos(w)), std::abs(p.velocity[1][0] + w * std::sin(w)),
            std::abs(p.density_deviation[0] - (std::exp(-rate) - 1.0))};
}

/// Order seen from `steps` to twice as many.
SpringError spring_order(Stepping stepping, int steps, double unevenness) {
    const SpringError a = spring_error(stepping, steps, unevenness);
    const SpringError b = spring_error(stepping, 2 * steps, unevenness);
    return {std::log2(a.position / b.position), std::log2(a.velocity / b.velocity),
            std::log2(a.density / b.density)};
}

// Orders of the formulae themselves, to 0.1 of what theory says: 2, and 3 for the Adams-Bashforth-Moulton
// formulae of Beeman's method; these keep it with steps of any length.
TEST(Stepper, HasItsOrder) {
    for (const Stepping stepping : {Stepping::predictor_corrector, Stepping::symplectic}) {
        const SpringError order = spring_order(stepping, 400, 0.3);
        EXPECT_NEAR(order.position, 2.0, 0.1) << word(stepping);
        EXPECT_NEAR(order.velocity, 2.0, 0.1) << word(stepping);
        EXPECT_NEAR(order.density, 2.0, 0.1) << word(stepping);
    }
    for (const double unevenness : {0.0, 0.3}) {
        const SpringError order = spring_order(Stepping::beeman, 100, unevenness);
        EXPECT_NEAR(order.position, 3.0, 0.1);
        EXPECT_NEAR(order.velocity, 3.0, 0.1);
        EXPECT_NEAR(order.density, 3.0, 0.1);
    }
    const SpringError verlet = spring_order(Stepping::verlet, 400, 0.0);
    EXPECT_NEAR(verlet.position, 2.0, 0.1);
    EXPECT_NEAR(verlet.velocity, 2.0, 0.1);
    EXPECT_NEAR(verlet.density, 2.0, 0.1);
}

// The equations as printed, for equal steps.
TEST(Stepper, BeemanIsThePublishedFormula) {
    const auto stepper = make_stepper<2>(Stepping::beeman);
    Particles<2> p;
    p.resize(1);
    p.position[0][0] = 0.3;
    p.velocity[0][0] = 1.1;
    p.density_deviation[0] = 0.01;
    stepper->declare(p);
    for (FurtherField& field : p.further) field.values.assign(1, 0.0);
    ASSERT_EQ(p.further.front().info.name, "previous_motion_x");
    ASSERT_EQ(p.further.back().info.name, "previous_density");
    p.further.front().values[0] = 5.0;
    p.further.back().values[0] = 0.7;
    const double dt = 0.01;
    stepper->begin(p, {.now = dt, .before = dt, .steps = 1});
    ParticleRates<2> now{.density = 0.4};
    now.acceleration[0] = 3.0;
    stepper->advance(0, 0, now, p);
    EXPECT_DOUBLE_EQ(p.position[0][0], 0.3 + dt * 1.1 + dt * dt * (4.0 * 3.0 - 5.0) / 6.0);
    EXPECT_DOUBLE_EQ(p.velocity[0][0], 1.1 + dt * (3.0 * 3.0 - 5.0) / 2.0);
    EXPECT_DOUBLE_EQ(p.density_deviation[0], 0.01 + dt * (3.0 * 0.4 - 0.7) / 2.0);
    ParticleRates<2> next{.density = 0.2};
    next.acceleration[0] = 2.0;
    stepper->advance(1, 0, next, p);
    EXPECT_DOUBLE_EQ(p.position[0][0], 0.3 + dt * 1.1 + dt * dt * (2.0 + 2.0 * 3.0) / 6.0);
    EXPECT_DOUBLE_EQ(p.velocity[0][0], 1.1 + dt * (5.0 * 2.0 + 8.0 * 3.0 - 5.0) / 12.0);
    EXPECT_DOUBLE_EQ(p.density_deviation[0], 0.01 + dt * (5.0 * 0.2 + 8.0 * 0.4 - 0.7) / 12.0);
    EXPECT_EQ(p.further.front().values[0], 3.0);
}

TEST(Stepper, VerletLeapsOverTwoStepsAndStartsAgainAfterAFilter) {
    const auto stepper = make_stepper<2>(Stepping::verlet);
    Particles<2> p;
    p.resize(1);
    stepper->declare(p);
    ParticleRates<2> rates{.density = 2.0};
    rates.acceleration[0] = 1.0;
    const double dt = 0.5;
    const auto step = [&](std::int64_t n, bool restart) {
        stepper->begin(p, {.now = dt, .before = dt, .steps = n, .restart = restart});
        stepper->advance(0, 0, rates, p);
        return p.velocity[0][0];
    };
    EXPECT_DOUBLE_EQ(step(0, false), dt);  // Euler
    rates.acceleration[0] = 3.0;
    EXPECT_DOUBLE_EQ(step(1, false), 2.0 * dt * 3.0);            // from the state at 0
    EXPECT_DOUBLE_EQ(step(2, true), 2.0 * dt * 3.0 + dt * 3.0);  // Euler again
}

}  // namespace
}  // namespace riffle::stepping_test
