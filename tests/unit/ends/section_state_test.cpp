#include "ends/section_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "case/end_levels.hpp"

namespace riffle {
namespace {

constexpr double gravity = 9.81;

double coming(const Section& section) { return section.velocity - 2.0 * wave_speed(gravity, section.depth); }
double going(const Section& section) { return section.velocity + 2.0 * wave_speed(gravity, section.depth); }

// Where the reach already carries the discharge, an end changes nothing: whatever the depth.
TEST(SectionState, UniformFlowStaysAsItIs) {
    for (const double froude : {0.05, 0.3, 0.6, 0.95}) {
        for (const double depth : {0.01, 0.056, 2.0}) {
            const Section reach{depth, froude * wave_speed(gravity, depth)};
            const Section inflow = inflow_by_discharge(gravity, reach.depth * reach.velocity, coming(reach));
            EXPECT_NEAR(inflow.depth / depth, 1.0, 1e-10) << froude;
            EXPECT_NEAR(inflow.velocity / reach.velocity, 1.0, 1e-10);
            const Section outflow = outflow_between(gravity, going(reach), coming(reach));
            EXPECT_NEAR(outflow.depth / depth, 1.0, 1e-12);
            EXPECT_NEAR(outflow.velocity / reach.velocity, 1.0, 1e-12);
            EXPECT_NEAR(inflow_by_depth(gravity, depth, coming(reach)).velocity / reach.velocity, 1.0, 1e-12);
        }
    }
}

/// A trapezoid: bottom 0.3 m, banks 1:1 in a channel of 0.9 m.
LongWaves trapezoid() {
    return {gravity, std::make_shared<const SectionShape>(std::vector<double>{0.0, 0.3},
                                                          std::vector<double>{1.0 / 3.0, 1.0},
                                                          std::vector<double>{1.0, 2.0})};
}

TEST(SectionState, AndSoInACanal) {
    const LongWaves waves = trapezoid();
    for (const double froude : {0.05, 0.3, 0.6, 0.95}) {
        for (const double depth : {0.01, 0.15, 0.29, 0.5}) {
            const Section reach{depth, froude * wave_speed(waves, depth)};
            const double invariant = reach.velocity - waves.invariant(depth);
            const double going = reach.velocity + waves.invariant(depth);
            const double q = waves.area(depth) * reach.velocity;
            EXPECT_NEAR(inflow_by_discharge(waves, q, invariant).depth / depth, 1.0, 1e-9) << froude;
            EXPECT_NEAR(outflow_between(waves, going, invariant).depth / depth, 1.0, 1e-9);
            EXPECT_NEAR(inflow_by_depth(waves, depth, invariant).velocity / reach.velocity, 1.0, 1e-9);
            // A small change of an invariant changes discharge and depth by as much as it is asked to.
            const double change = 1e-6 * q;
            const Section more =
                outflow_between(waves, going + invariant_of_discharge(waves, reach, change), invariant);
            EXPECT_NEAR((waves.area(more.depth) * more.velocity - q) / change, 1.0, 1e-4);
            const double rise = 1e-6 * depth;
            const Section higher =
                outflow_between(waves, going, invariant + invariant_of_depth(waves, reach, rise));
            EXPECT_NEAR((higher.depth - depth) / rise, 1.0, 1e-4);
        }
    }
    const double q = 0.1;
    const double critical = waves.critical_depth(q);
    EXPECT_NEAR(q / waves.area(critical), wave_speed(waves, critical), 1e-9);
    const double going = wave_speed(waves, critical) + waves.invariant(critical);
    EXPECT_NEAR(invariant_of_critical_flow(waves, going),
                wave_speed(waves, critical) - waves.invariant(critical), 1e-9);
    EXPECT_NEAR(waves.sequent_depth(critical, wave_speed(waves, critical)), critical, 1e-6);
}

TEST(SectionState, InflowCarriesItsDischargeWhateverComesUpTheChannel) {
    const double q = 0.02;
    for (const double invariant : {-3.0, -2.0, -1.5, -1.0, -0.5, 0.0, 1.0}) {
        const Section section = inflow_by_discharge(gravity, q, invariant);
        EXPECT_NEAR(section.depth * section.velocity / q, 1.0, 1e-12) << invariant;
        EXPECT_GE(section.depth, critical_depth_of(gravity, q) * (1.0 - 1e-12)) << invariant;
    }
}

TEST(SectionState, WaterAtRestFlowsInNowhere) {
    const double depth = 0.1;
    const Section rest{depth, 0.0};
    const Section section = inflow_by_discharge(gravity, 0.0, coming(rest));
    EXPECT_NEAR(section.depth, depth, 1e-12);
    EXPECT_EQ(section.velocity, 0.0);
}

TEST(SectionState, CriticalFlowHasTheSpeedOfItsWaves) {
    const double q = 0.0435;
    const double depth = critical_depth_of(gravity, q);
    EXPECT_NEAR(q / depth, wave_speed(gravity, depth), 1e-12);
}

// The depth goes to what rules it, by e in each relaxation time.
TEST(SectionState, RelaxationBringsTheDepthHome) {
    const double wanted = 0.05;
    const double time = 2.0;
    Section now{0.055, 0.3};
    const double going_down = going(now);
    double invariant = coming(now);
    const double dt = 1e-3;
    for (double t = 0.0; t < time - 0.5 * dt; t += dt) {
        invariant += relaxation(gravity, now, wanted, time, dt);
        now = outflow_between(gravity, going_down, invariant);
    }
    // To the share by which the wave's speed changes with the depth.
    EXPECT_NEAR((now.depth - wanted) / 0.005, std::exp(-1.0), 0.02);
}

// What a wave of the period T throws back: 1/sqrt(1 + (2 pi time/T)^2).
TEST(SectionState, ALongerRelaxationThrowsLessOfAWaveBack) {
    const double depth = 0.056;
    const double time = 4.0;
    for (const double period : {0.5, 1.0, 4.0}) {
        Section now{depth, 0.0};
        double invariant = coming(now);
        double high = -10.0;
        double low = 10.0;
        const double dt = 1e-4 * period;
        const double amplitude = 1e-4;
        for (int i = 0; i < 200000; ++i) {
            const double wave = amplitude * std::sin(2.0 * M_PI * i * dt / period);
            invariant += relaxation(gravity, now, depth, time, dt);
            now = outflow_between(gravity, 2.0 * wave_speed(gravity, depth) + wave, invariant);
            if (i >= 190000) {  // the last period
                high = std::max(high, invariant);
                low = std::min(low, invariant);
            }
        }
        const double expected = 1.0 / std::sqrt(1.0 + std::pow(2.0 * M_PI * time / period, 2));
        EXPECT_NEAR(0.5 * (high - low) / amplitude / expected, 1.0, 0.02) << period;
    }
}

// A discharge that comes home in time lets the waves out: of one of the period T (1 - Fr)/(1 + Fr)/sqrt(1 +
// (2 pi time/T)^2) comes back, and its mean is the one wanted.
TEST(SectionState, ADischargeThatComesHomeInTimeLetsWavesOut) {
    const double depth = 0.4;
    const double time = 2.0;
    for (const double froude : {0.0, 0.1, 0.5}) {
        for (const double period : {0.5, 2.0, 8.0}) {
            const Section reach{depth, froude * wave_speed(gravity, depth)};
            const double wanted = depth * reach.velocity;
            double invariant = going(reach);
            double high = -100.0;
            double low = 100.0;
            double mean = 0.0;
            const double amplitude = 1e-4;
            constexpr int per_period = 2000;
            const double dt = period / per_period;
            const int periods = 2 + static_cast<int>(std::ceil(12.0 * time / period));
            for (int i = 0; i < periods * per_period; ++i) {
                const double wave = amplitude * std::sin(2.0 * M_PI * i / per_period);
                const Section now = outflow_between(gravity, invariant, coming(reach) + wave);
                invariant +=
                    invariant_of_discharge(gravity, now, (wanted - now.depth * now.velocity) * dt / time);
                if (i >= (periods - 1) * per_period) {
                    high = std::max(high, invariant);
                    low = std::min(low, invariant);
                    mean += now.depth * now.velocity / per_period;
                }
            }
            const double expected =
                (1.0 - froude) / (1.0 + froude) / std::sqrt(1.0 + std::pow(2.0 * M_PI * time / period, 2));
            EXPECT_NEAR(0.5 * (high - low) / amplitude / expected, 1.0, 0.02) << froude << ' ' << period;
            EXPECT_NEAR((mean - wanted) / (depth * wave_speed(gravity, depth)), 0.0, 1e-8);
        }
    }
}

}  // namespace
}  // namespace riffle
