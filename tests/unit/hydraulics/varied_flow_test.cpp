#include "hydraulics/varied_flow.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace riffle {
namespace {

constexpr double gravity = 9.81;

/// A wide channel of constant friction factor: S_f = sin(theta) (h_n/h)^3, for which Bresse gave the
/// surface in closed form.
SteadyChannel bresse_channel(double slope, double normal, double critical) {
    const double cosine = std::cos(std::atan(slope));
    SteadyChannel channel{.slope = slope,
                          .gravity = gravity,
                          .unit_discharge = std::sqrt(gravity * cosine * critical * critical * critical),
                          .state = {}};
    const double sine = std::sin(std::atan(slope));
    channel.state = [=, q = channel.unit_discharge](double h) {
        return SectionState{.friction_slope = sine * std::pow(normal / h, 3), .mean_velocity = q / h};
    };
    return channel;
}

/// Bresse's function, d(phi)/d(eta) = 1/(1 - eta^3).
double bresse_function(double eta) {
    const double root = std::sqrt(3.0);
    return std::log((eta * eta + eta + 1.0) / ((eta - 1.0) * (eta - 1.0))) / 6.0 +
           std::atan((2.0 * eta + 1.0) / root) / root;
}

/// Distance along the bed from depth `from` to depth `to`.
double bresse_distance(double slope, double normal, double critical, double from, double to) {
    const double ratio = std::pow(critical / normal, 3);
    const auto place = [&](double h) {
        const double eta = h / normal;
        return eta - (1.0 - ratio) * bresse_function(eta);
    };
    return normal / slope * (place(to) - place(from));
}

struct Curve {
    std::string name;
    double slope, normal, critical;
    double control;  ///< depth at the end that rules it
    double other;    ///< a depth that it passes
};

class AllCurves : public ::testing::TestWithParam<Curve> {};

TEST_P(AllCurves, FollowBresse) {
    const Curve& p = GetParam();
    const SteadyChannel channel = bresse_channel(p.slope, p.normal, p.critical);
    const double distance = std::abs(bresse_distance(p.slope, p.normal, p.critical, p.control, p.other));
    const bool supercritical = p.control < p.critical;
    ChannelControls controls{.length = distance, .upstream_depth = {}, .downstream_depth = {}};
    (supercritical ? controls.upstream_depth : controls.downstream_depth) = p.control;
    if (supercritical && p.normal > p.critical) {
        controls.downstream_depth = p.critical;  // so low that the jump is swept out
    }
    const VariedFlow flow = solve_varied_flow(channel, controls);
    ASSERT_EQ(flow.profiles.size(), flow.jump ? 2U : 1U);
    const SurfaceProfile& part = supercritical || !flow.jump ? flow.profiles.front() : flow.profiles.back();
    EXPECT_EQ(part.name, p.name);
    EXPECT_NEAR(part.curve.depth_at(supercritical ? 0.0 : distance), p.control, 1e-12);
    EXPECT_NEAR(part.curve.depth_at(supercritical ? distance : 0.0), p.other, 1e-9 * p.other);
    // Half of the way, by the same formula.
    const double middle = part.curve.depth_at(0.5 * distance);
    EXPECT_NEAR(std::abs(bresse_distance(p.slope, p.normal, p.critical, p.control, middle)), 0.5 * distance,
                1e-8 * distance);
}

INSTANTIATE_TEST_SUITE_P(
    Bresse, AllCurves,
    ::testing::Values(Curve{"M1", 0.001, 1.0, 0.5, 3.0, 1.01}, Curve{"M2", 0.001, 1.0, 0.5, 0.5, 0.99},
                      Curve{"M3", 0.001, 1.0, 0.5, 0.1, 0.35}, Curve{"S1", 0.05, 0.5, 1.0, 3.0, 1.001},
                      Curve{"S2", 0.05, 0.5, 1.0, 0.999, 0.505}, Curve{"S3", 0.05, 0.5, 1.0, 0.1, 0.495}),
    [](const auto& curve) { return curve.param.name; });

// On a horizontal bed with S_f = k/h^3 the surface is a polynomial of its depth.
TEST(VariedFlow, HorizontalBedsAreExact) {
    constexpr double k = 2e-3;
    constexpr double q = 1.0;
    SteadyChannel channel{.slope = 0.0, .gravity = gravity, .unit_discharge = q, .state = {}};
    channel.state = [](double h) {
        return SectionState{.friction_slope = k / (h * h * h), .mean_velocity = q / h};
    };
    const double critical = std::cbrt(q * q / gravity);
    EXPECT_NEAR(critical_depth(channel), critical, 1e-12);
    EXPECT_FALSE(normal_depth(channel));
    const auto place = [&](double h) {
        return -(0.25 * h * h * h * h - critical * critical * critical * h) / k;
    };
    const double length = place(critical) - place(1.0);
    const VariedFlow falling =
        solve_varied_flow(channel, {.length = length, .upstream_depth = {}, .downstream_depth = critical});
    EXPECT_EQ(falling.slope, SlopeClass::horizontal);
    EXPECT_EQ(falling.profiles.front().name, "H2");
    EXPECT_NEAR(falling.depth_at(0.0), 1.0, 1e-9);
    const double short_length = place(0.35) - place(0.2);
    const VariedFlow shooting = solve_varied_flow(
        channel, {.length = short_length, .upstream_depth = 0.2, .downstream_depth = critical});
    EXPECT_EQ(shooting.profiles.front().name, "H3");
    EXPECT_NEAR(shooting.profiles.front().curve.depth_at(short_length), 0.35, 1e-9);
}

// What the energy grade line loses is the friction slope along the way.
TEST(VariedFlow, EnergyFallsByTheFriction) {
    const SteadyChannel channel = manning_channel(0.002, gravity, 0.8, 0.02);
    const VariedFlow flow =
        solve_varied_flow(channel, {.length = 400.0, .upstream_depth = {}, .downstream_depth = 1.5});
    constexpr int steps = 4000;
    double lost = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double x = 400.0 * (i + 0.5) / steps;
        lost += channel.state(flow.depth_at(x)).friction_slope * 400.0 / steps;
    }
    const double fall = channel.energy_head(flow.depth_at(0.0)) + 400.0 * std::sin(std::atan(0.002)) -
                        channel.energy_head(flow.depth_at(400.0));
    // The velocity head of the energy has g, the momentum g cos(theta): equal to 2e-6 here.
    EXPECT_NEAR(fall, lost, 1e-5 * lost);
}

TEST(VariedFlow, SequentDepthsAreThoseOfBelanger) {
    const SteadyChannel channel = manning_channel(0.0, gravity, 1.2, 0.015);
    const double critical = critical_depth(channel);
    for (const double froude : {1.3, 2.0, 4.0, 9.0}) {
        const double before = std::cbrt(1.2 * 1.2 / (gravity * froude * froude));
        EXPECT_NEAR(channel.froude_number(before), froude, 1e-9 * froude);
        const double after = 0.5 * before * (std::sqrt(1.0 + 8.0 * froude * froude) - 1.0);
        EXPECT_NEAR(*sequent_depth(channel, before, critical), after, 1e-10 * after);
        EXPECT_NEAR(*sequent_depth(channel, after, critical), before, 1e-9 * before);
        // The head that the jump takes, (h2 - h1)^3/(4 h1 h2).
        EXPECT_NEAR(channel.energy_head(before) - channel.energy_head(after),
                    std::pow(after - before, 3) / (4.0 * before * after), 1e-9);
    }
}

// A jump stands where the water before and behind it push alike, and moves upstream when the level rises.
TEST(VariedFlow, JumpsStandWhereTheMomentumFunctionsMeet) {
    const SteadyChannel channel = manning_channel(0.001, gravity, 0.5, 0.015);
    double last = 1e9;
    for (const double level : {0.56, 0.60, 0.64}) {
        const VariedFlow flow =
            solve_varied_flow(channel, {.length = 60.0, .upstream_depth = 0.12, .downstream_depth = level});
        ASSERT_TRUE(flow.jump);
        EXPECT_NEAR(channel.momentum(flow.jump->depth_before), channel.momentum(flow.jump->depth_after),
                    1e-9);
        EXPECT_LT(flow.jump->place, last);
        last = flow.jump->place;
        EXPECT_GT(flow.jump->head_loss, 0.0);
        EXPECT_EQ(flow.profiles.front().name, "M3");
        EXPECT_DOUBLE_EQ(flow.profiles.front().to, flow.jump->place);
        EXPECT_DOUBLE_EQ(flow.profiles.back().to, 60.0);
        EXPECT_NEAR(flow.depth_at(60.0), level, 1e-12);
    }
}

// The curve that dh/dx gives by small steps, with the friction of Manning.
TEST(VariedFlow, AgreesWithStepsAlongTheChannel) {
    const SteadyChannel channel = manning_channel(0.003, gravity, 0.4, 0.025);
    const VariedFlow flow =
        solve_varied_flow(channel, {.length = 120.0, .upstream_depth = {}, .downstream_depth = 0.9});
    const auto gradient = [&](double h) {
        return gravity * h * channel.surplus_slope(h) / channel.momentum_gradient(h);
    };
    double h = 0.9;
    constexpr double step = 0.01;
    for (int i = 0; i < 12000; ++i) {
        const double k1 = gradient(h);
        const double k2 = gradient(h - 0.5 * step * k1);
        const double k3 = gradient(h - 0.5 * step * k2);
        const double k4 = gradient(h - step * k3);
        h -= step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    EXPECT_NEAR(flow.depth_at(0.0), h, 1e-8);
}

TEST(VariedFlow, NamesAllCurves) {
    EXPECT_EQ(profile_name(3, 1, 2.0, SlopeClass::mild), "M1");
    EXPECT_EQ(profile_name(1.5, 1, 2.0, SlopeClass::mild), "M2");
    EXPECT_EQ(profile_name(0.5, 1, 2.0, SlopeClass::mild), "M3");
    EXPECT_EQ(profile_name(3, 2, 1.0, SlopeClass::steep), "S1");
    EXPECT_EQ(profile_name(1.5, 2, 1.0, SlopeClass::steep), "S2");
    EXPECT_EQ(profile_name(0.5, 2, 1.0, SlopeClass::steep), "S3");
    EXPECT_EQ(profile_name(2, 1, 1.0, SlopeClass::critical), "C1");
    EXPECT_EQ(profile_name(0.5, 1, 1.0, SlopeClass::critical), "C3");
    EXPECT_EQ(profile_name(2, 1, {}, SlopeClass::horizontal), "H2");
    EXPECT_EQ(profile_name(0.5, 1, {}, SlopeClass::horizontal), "H3");
    EXPECT_EQ(profile_name(2, 1, {}, SlopeClass::adverse), "A2");
    EXPECT_EQ(profile_name(0.5, 1, {}, SlopeClass::adverse), "A3");
    EXPECT_EQ(profile_name(2, 1, 2.0, SlopeClass::mild), "uniform");
}

TEST(VariedFlow, UniformFlowStaysUniform) {
    const SteadyChannel channel = rough_channel(0.004, gravity, 0.02, 0.03);
    const double normal = *normal_depth(channel);
    const VariedFlow flow =
        solve_varied_flow(channel, {.length = 50.0, .upstream_depth = {}, .downstream_depth = {}});
    ASSERT_EQ(flow.profiles.size(), 1U);
    EXPECT_EQ(flow.profiles.front().name, "uniform");
    EXPECT_NEAR(flow.depth_at(20.0), normal, 1e-12);
    EXPECT_NEAR(rough_unit_discharge(0.004, gravity, normal, 0.03), 0.02, 1e-12);
    EXPECT_NEAR(manning_unit_discharge(0.01, *normal_depth(manning_channel(0.01, gravity, 0.5, 0.02)), 0.02),
                0.5, 1e-10);
}

TEST(VariedFlow, TellsOfJumpsWithoutPlace) {
    const SteadyChannel channel = manning_channel(0.05, gravity, 0.5, 0.015);
    const double normal = *normal_depth(channel);
    const double sequent = *sequent_depth(channel, normal, critical_depth(channel));
    const VariedFlow swept = solve_varied_flow(
        channel, {.length = 20.0, .upstream_depth = {}, .downstream_depth = 0.95 * sequent});
    EXPECT_FALSE(swept.jump);
    ASSERT_EQ(swept.events.size(), 1U);
    EXPECT_THAT(swept.events.front(), ::testing::HasSubstr("swept out"));
    EXPECT_NEAR(swept.depth_at(20.0), normal, 1e-9);
    const VariedFlow drowned =
        solve_varied_flow(channel, {.length = 5.0, .upstream_depth = {}, .downstream_depth = sequent + 0.5});
    EXPECT_FALSE(drowned.jump);
    ASSERT_EQ(drowned.events.size(), 1U);
    EXPECT_THAT(drowned.events.front(), ::testing::HasSubstr("drowned"));
    EXPECT_GT(drowned.depth_at(0.0), critical_depth(channel));
}

// At the slope of critical uniform flow, and a hair beside it, both curves end at the critical depth.
TEST(VariedFlow, CriticalSlopesKeepBothDepths) {
    const double q = 0.05;
    const double critical = std::cbrt(q * q / gravity);
    const double slope = 0.02 * 0.02 * q * q / std::pow(critical, 10.0 / 3.0);
    for (const double factor : {1.0 - 2e-5, 1.0, 1.0 + 2e-5}) {
        const SteadyChannel channel = manning_channel(factor * slope, gravity, q, 0.02);
        const VariedFlow flow = solve_varied_flow(
            channel, {.length = 20.0, .upstream_depth = 0.5 * critical, .downstream_depth = 1.3 * critical});
        EXPECT_EQ(flow.slope, SlopeClass::critical);
        EXPECT_FALSE(flow.jump);
        EXPECT_TRUE(flow.events.empty());
        ASSERT_EQ(flow.profiles.size(), 3U);
        EXPECT_EQ(flow.profiles[0].name, "C3");
        EXPECT_EQ(flow.profiles[1].name, "uniform");
        EXPECT_EQ(flow.profiles[2].name, "C1");
        EXPECT_NEAR(flow.depth_at(0.0), 0.5 * critical, 1e-12);
        EXPECT_NEAR(flow.depth_at(20.0), 1.3 * critical, 1e-12);
        EXPECT_NEAR(flow.depth_at(10.0), critical, 1e-3 * critical);
    }
}

// A thin flow that nowhere comes near its critical depth needs no friction there.
TEST(VariedFlow, KnowsFlowsWhoseCriticalDepthIsBelowTheRoughness) {
    const SteadyChannel channel = rough_channel(0.004, gravity, 0.0145, 0.035);
    EXPECT_LT(critical_depth(channel), 0.035);
    const VariedFlow flow =
        solve_varied_flow(channel, {.length = 20.0, .upstream_depth = {}, .downstream_depth = 0.08});
    EXPECT_EQ(flow.profiles.front().name, "M1");
    EXPECT_THROW(
        static_cast<void>(solve_varied_flow(
            channel, {.length = 20.0, .upstream_depth = {}, .downstream_depth = critical_depth(channel)})),
        InputError);
}

TEST(VariedFlow, AdverseBedsRiseUpstream) {
    const SteadyChannel channel = manning_channel(-0.002, gravity, 0.3, 0.02);
    const VariedFlow flow =
        solve_varied_flow(channel, {.length = 50.0, .upstream_depth = {}, .downstream_depth = 0.4});
    EXPECT_EQ(flow.slope, SlopeClass::adverse);
    EXPECT_EQ(flow.profiles.front().name, "A2");
    // Deeper by the rise of the bed and by the friction.
    EXPECT_GT(flow.depth_at(0.0), 0.4 + 50.0 * 0.002);
}

TEST(VariedFlow, RefusesControlsThatCannotHold) {
    const SteadyChannel mild = manning_channel(0.001, gravity, 0.5, 0.02);
    const auto message = [](const SteadyChannel& channel, const ChannelControls& controls) {
        try {
            static_cast<void>(solve_varied_flow(channel, controls));
        } catch (const InputError& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    EXPECT_THAT(message(mild, {.length = 10.0, .upstream_depth = {}, .downstream_depth = 0.1}),
                ::testing::HasSubstr("below the critical depth"));
    EXPECT_THAT(message(mild, {.length = 10.0, .upstream_depth = 0.8, .downstream_depth = {}}),
                ::testing::HasSubstr("ruled by its downstream end"));
    const SteadyChannel flat = manning_channel(0.0, gravity, 0.5, 0.02);
    EXPECT_THAT(message(flat, {.length = 10.0, .upstream_depth = {}, .downstream_depth = {}}),
                ::testing::HasSubstr("no normal depth"));
    const SteadyChannel coarse = rough_channel(0.3, gravity, 1e-4, 0.05);
    EXPECT_THAT(message(coarse, {.length = 10.0, .upstream_depth = {}, .downstream_depth = {}}),
                ::testing::HasSubstr("is less than 0.05 m"));
}

TEST(VariedFlow, ApproachLengthsEndWithinTheShare) {
    const SteadyChannel channel = manning_channel(0.002, gravity, 0.6, 0.02);
    const ChannelControls controls{.length = 0.0, .upstream_depth = {}, .downstream_depth = 1.2};
    const double length = *approach_length(channel, controls, 0.01);
    const VariedFlow flow =
        solve_varied_flow(channel, {.length = length, .upstream_depth = {}, .downstream_depth = 1.2});
    EXPECT_NEAR(flow.depth_at(0.0), 1.01 * *flow.normal_depth, 1e-9);
    EXPECT_FALSE(
        approach_length(channel, {.length = 0.0, .upstream_depth = 0.1, .downstream_depth = {}}, 0.01));
}

}  // namespace
}  // namespace riffle
