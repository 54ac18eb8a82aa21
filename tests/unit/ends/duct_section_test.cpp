#include "ends/duct_section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace riffle {
namespace {

constexpr double sound_speed = 30.0;

// A section has the invariants that it is made of.
TEST(DuctSection, HasItsInvariants) {
    const DuctSection section = duct_section(sound_speed, 0.7, 0.2);
    EXPECT_NEAR(section.velocity + section.pressure / sound_speed, 0.7, 1e-15);
    EXPECT_NEAR(section.velocity - section.pressure / sound_speed, 0.2, 1e-15);
}

/// Amplitude of what an inflow sends back of sound of a period that comes with the amplitude 1.
double reflection_of_inflow(double time, double period) {
    const double omega = 2.0 * std::numbers::pi / period;
    const double dt = period / 2000.0;
    const double mean = 0.5;
    DuctSection now{mean, 0.0};
    double in_phase = 0.0;
    double out_of_phase = 0.0;
    const int steps = 2000 * 40;
    for (int i = 1; i <= steps; ++i) {
        const double t = i * dt;
        now = duct_inflow(sound_speed, now, mean + std::sin(omega * t), mean, 0.0, time, dt);
        if (i > steps - 2000) {
            const double going = now.velocity + now.pressure / sound_speed - mean;
            in_phase += going * std::sin(omega * t) * 2.0 / 2000.0;
            out_of_phase += going * std::cos(omega * t) * 2.0 / 2000.0;
        }
    }
    return std::hypot(in_phase, out_of_phase);
}

TEST(DuctSection, AnInflowThrowsBackWhatItsRelaxationTimeSays) {
    const double period = 0.01;
    EXPECT_NEAR(reflection_of_inflow(0.0, period), 1.0, 1e-3);
    for (const double time : {0.002, 0.01, 0.05}) {
        const double expected = 1.0 / std::hypot(1.0, 2.0 * std::numbers::pi * time / period);
        EXPECT_NEAR(reflection_of_inflow(time, period) / expected, 1.0, 0.02) << time;
    }
}

TEST(DuctSection, ADischargeThatChangesEntersAtOnce) {
    const DuctSection now{0.5, 0.1};
    const double coming = now.velocity - now.pressure / sound_speed;
    const DuctSection after = duct_inflow(sound_speed, now, coming, 0.6, 0.1, 1e6, 1e-4);
    EXPECT_NEAR(after.velocity, 0.6, 1e-9);
}

// The pressure of the outflow goes home by e in each relaxation time.
TEST(DuctSection, ThePressureComesHome) {
    const double going = 0.6;
    const double wanted = 2.0;
    const double time = 0.3;
    double coming = 0.2;
    const double dt = 1e-4;
    const double first = duct_section(sound_speed, going, coming).pressure - wanted;
    for (int i = 0; i < 3000; ++i) {
        coming += duct_relaxation(sound_speed, duct_section(sound_speed, going, coming), wanted, time, dt);
    }
    EXPECT_NEAR((duct_section(sound_speed, going, coming).pressure - wanted) / first, std::exp(-1.0), 1e-3);
}

}  // namespace
}  // namespace riffle
