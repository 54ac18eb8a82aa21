#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "check_run.hpp"
#include "damped_wave.hpp"

using namespace riffle;
using namespace riffle::verification;

namespace {

/// Six periods of the wave: its first mode, fitted by a damped oscillation.
void check_wave(const std::string& form, SurfaceCondition condition) {
    CheckRun run("standing-wave", {{"numerics.viscosity", form}});
    const Case& c = run.parameters();
    const double k = 2.0 * std::numbers::pi / c.channel.length;
    const double nu = c.fluid.kinematic_viscosity;
    const DampedWave exact = viscous_wave(c.fluid.gravity, k, c.total_depth(), nu, condition);
    std::vector<double> time;
    std::vector<double> amplitude;
    run.advance_to(6.0 * 2.0 * std::numbers::pi / exact.frequency, [&] {
        const Particles<2>& p = run.particles();
        time.push_back(run.time());
        amplitude.push_back(mass_mean(
            p, [&](std::size_t i) { return 2.0 * p.position[1][i] * std::cos(k * p.position[0][i]); }));
    });
    const DampedWave measured = fit_damped_wave(time, amplitude, exact);
    const double inviscid = std::sqrt(c.fluid.gravity * k * std::tanh(k * c.total_depth()));
    const std::string label = "standing wave, " + form;
    expect_below(label, "period against the viscous wave", 0.01,
                 std::abs(exact.frequency / measured.frequency - 1.0));
    expect_below(label, "period against 2 pi / sqrt(g k tanh kH)", 0.01,
                 std::abs(inviscid / measured.frequency - 1.0));
    expect_below(label, "decay against the viscous wave", 0.05, std::abs(measured.decay / exact.decay - 1.0));
}

}  // namespace

// The fit itself, on an exact oscillation.
TEST(StandingWave, FitRecoversAnOscillation) {
    std::vector<double> time;
    std::vector<double> value;
    for (int i = 0; i < 500; ++i) {
        const double t = 0.004 * i;
        time.push_back(t);
        value.push_back(std::exp(-0.8 * t) * (0.3 * std::cos(17.0 * t) - 0.7 * std::sin(17.0 * t)));
    }
    const DampedWave fit = fit_damped_wave(time, value, {.frequency = 17.5, .decay = 1.0});
    EXPECT_NEAR(fit.frequency, 17.0, 1e-9);
    EXPECT_NEAR(fit.decay, 0.8, 1e-9);
}

// To first order in nu the two conditions damp by 2 nu k^2 and nu k^2.
TEST(StandingWave, ExactWaveHasTheKnownLimits) {
    const double k = 31.4;
    const double nu = 1e-7;
    const double square = 9.81 * k * std::tanh(k * 0.1);
    const DampedWave traction = viscous_wave(9.81, k, 0.1, nu, SurfaceCondition::zero_traction);
    const DampedWave gradient = viscous_wave(9.81, k, 0.1, nu, SurfaceCondition::zero_velocity_gradient);
    EXPECT_NEAR(traction.decay / (2.0 * nu * k * k), 1.0, 0.01);
    EXPECT_NEAR(gradient.decay / (nu * k * k), 1.0, 0.01);
    EXPECT_NEAR(traction.frequency / std::sqrt(square), 1.0, 1e-4);
}

TEST(StandingWave, ZeroTractionWithMonaghanGingold) {
    check_wave("monaghan-gingold", SurfaceCondition::zero_traction);
}

TEST(StandingWave, ZeroVelocityGradientWithMorris) {
    check_wave("morris", SurfaceCondition::zero_velocity_gradient);
}

// Almost inviscid water: the period, and the decay that is the scheme's own.
TEST(StandingWave, PeriodOfWater) {
    CheckRun run("standing-wave", {{"fluid.kinematic_viscosity", "1e-6"}});
    const Case& c = run.parameters();
    const double k = 2.0 * std::numbers::pi / c.channel.length;
    const double inviscid = std::sqrt(c.fluid.gravity * k * std::tanh(k * c.total_depth()));
    std::vector<double> time;
    std::vector<double> amplitude;
    run.advance_to(2.0, [&] {
        const Particles<2>& p = run.particles();
        time.push_back(run.time());
        amplitude.push_back(mass_mean(
            p, [&](std::size_t i) { return 2.0 * p.position[1][i] * std::cos(k * p.position[0][i]); }));
    });
    const DampedWave measured = fit_damped_wave(time, amplitude, {.frequency = inviscid, .decay = 0.03});
    expect_below("standing wave, water", "period against 2 pi / sqrt(g k tanh kH)", 0.01,
                 std::abs(inviscid / measured.frequency - 1.0));
    // Prototypes of the scheme damped 0.026 to 0.034 per second (theory 0.002).
    expect_below("standing wave, water", "decay, 1/s", 0.04, measured.decay);
}
