// The drag that takes the motion out of still water at the beginning of a run.

#include <gtest/gtest.h>

#include <cmath>

#include "record/flow_fields.hpp"
#include "same_bits.hpp"
#include "small_case.hpp"
#include "solver/series.hpp"

namespace riffle::settling_test {
namespace {

using test::ChannelIn;

/// Water of which all moves along a channel without friction: 0.1 m/s.
template <int D>
ChannelIn<D> moving_water(double settling_time, Top top = Top::free_surface) {
    Case c = test::still_water(D);
    c.channel.dimensions = D;
    c.channel.top = top;
    c.start.perturbation = 0.0;
    c.start.settling_time = settling_time;
    ChannelIn<D> channel(c);
    Particles<D> particles = channel.simulation->particles();
    for (double& u : particles.velocity[0]) u = 0.1;
    channel.simulation = make_simulation<D>(c, nullptr, std::move(particles));
    return channel;
}

template <int D>
double mean_velocity(const ChannelIn<D>& channel) {
    const auto& velocity = channel.simulation->particles().velocity[0];
    double sum = 0.0;
    for (const double u : velocity) sum += u;
    return sum / static_cast<double>(velocity.size());
}

/// Rate of the drag at the start, 1/s.
template <int D>
double rate_of(const ChannelIn<D>& channel) {
    return 4.0 * std::sqrt(channel.parameters.normal_gravity() / channel.simulation->scheme().depth);
}

template <int D>
void expect_decay(Top top = Top::free_surface) {
    const ChannelIn<D> channel = moving_water<D>(1000.0, top);
    constexpr int steps = 30;
    channel.advance(steps);
    const double rate = rate_of(channel);
    const double time = channel.simulation->clock().time;
    // Steps of first order, each of which takes rate * dt of the velocity.
    const double expected = 0.1 * std::exp(-rate * time);
    EXPECT_LT(expected, 0.07);
    EXPECT_NEAR(mean_velocity(channel), expected, rate * time * rate * time / steps * expected);
}

TEST(Settling, SlowsTheWaterByItsRate) {
    expect_decay<2>();
    expect_decay<2>(Top::wall);  // where the particles feel no gravity across the bed
    expect_decay<3>();
}

TEST(Settling, EndsWithItsTime) {
    const ChannelIn<2> channel = moving_water<2>(0.02);
    channel.advance_to(0.02);
    const double left = mean_velocity(channel);
    EXPECT_LT(left, 0.08);
    // The drag of the start would take half of it.
    channel.advance(30);
    EXPECT_NEAR(mean_velocity(channel), left, 0.01 * left);
}

// What it takes stands in the budget of the energy.
TEST(Settling, StandsInTheBudgetOfTheEnergy) {
    constexpr int steps = 10;
    const ChannelIn<2> channel = moving_water<2>(1000.0);
    channel.advance(steps);
    TimeSeries series(channel.parameters);
    series.sample(*channel.simulation, channel.parameters.total_depth());
    const auto& of = fields::time_series;
    // The power is that of the middle of the last step, the energy that of its end.
    const double power = 2.0 * rate_of(channel) * series.last(of.kinetic_energy);
    const double decay = 2.0 * rate_of(channel) * channel.simulation->clock().time / steps;
    EXPECT_NEAR(series.last(of.further_power), -power, 1.5 * decay * power);
}

TEST(Settling, GoesOnWithTheSameBitsAfterAResume) {
    Case c = test::still_water();
    c.start.jitter = 0.1;
    c.start.settling_time = 0.05;
    test::expect_same_bits_after_resume(c, 20, 20);
}

}  // namespace
}  // namespace riffle::settling_test
