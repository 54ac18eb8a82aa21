#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "ends/outgoing_sound.hpp"

namespace riffle {
namespace {

constexpr double node_spacing = 0.01;
constexpr double sound_run = 10.0;
constexpr double no_slow_time = 1e9;

/// Feed a bin with a pressure in time for `until` (s), in steps of the Courant number.
SoundBeyondEnd fed(OutgoingSound& sound, const std::function<double(double)>& pressure, double until,
                   double courant, double slow_time = no_slow_time, double most = 1e9) {
    SoundBeyondEnd state;
    const double dt = courant * node_spacing / sound_run;
    for (int step = 1; step * dt <= until + 1e-12; ++step) {
        sound.clear();
        sound.add({.upright = 0.25}, 1.0, pressure(step * dt));
        sound.add({.upright = 0.75}, 0.1, 1.0);
        sound.advance(state, sound_run, slow_time, 1.0, most, dt);
    }
    return state;
}

// A sine of 40 spacings arrives at a distance when sound does, whatever the step (one longer than a node
// too).
TEST(OutgoingSound, GoesOnWithTheSpeedOfSound) {
    for (const double courant : {0.1, 0.35, 0.8, 1.0, 1.6}) {
        OutgoingSound sound({.spacing = node_spacing, .length = 0.12, .bins_upright = 2});
        const double frequency = 2.0 * std::numbers::pi * sound_run / (40.0 * node_spacing);
        const auto pressure = [&](double t) { return std::sin(frequency * t); };
        const double dt = courant * node_spacing / sound_run;
        const double until = std::floor(0.1 / dt) * dt;
        const SoundBeyondEnd state = fed(sound, pressure, until, courant);
        for (const double distance : {0.0, 0.03, 0.075, 0.12}) {
            EXPECT_NEAR(sound.at(state.now, distance, {.upright = 0.25}),
                        pressure(until - distance / sound_run), courant > 1.0 ? 0.15 : 0.02)
                << courant << ", " << distance;
        }
    }
}

TEST(OutgoingSound, ABinWithoutWaterHasNoneAndPlacesLieBetweenBins) {
    OutgoingSound sound({.spacing = node_spacing, .length = 0.12, .bins_upright = 2});
    const SoundBeyondEnd state = fed(
        sound, [](double) { return 2.0; }, 0.1, 0.5);
    EXPECT_NEAR(sound.at(state.now, 0.05, {.upright = 0.1}), 2.0, 1e-6);
    EXPECT_NEAR(sound.at(state.now, 0.05, {.upright = 0.5}), 1.0, 1e-6);
    EXPECT_EQ(sound.at(state.now, 0.05, {.upright = 0.9}), 0.0);
    EXPECT_EQ(sound.at({}, 0.05, {.upright = 0.1}), 0.0);
}

// What lasts is the flow's, not sound; and no pressure above the largest is taken for sound.
TEST(OutgoingSound, WhatLastsIsNoSound) {
    OutgoingSound sound({.spacing = node_spacing, .length = 0.12, .bins_upright = 2});
    const SoundBeyondEnd lasting = fed(
        sound, [](double) { return 2.0; }, 0.2, 0.5, 0.02);
    EXPECT_NEAR(sound.at(lasting.now, 0.05, {.upright = 0.1}), 0.0, 1e-3);
    EXPECT_NEAR(lasting.slow[0], 2.0, 1e-3);
    const SoundBeyondEnd bounded = fed(
        sound, [](double) { return 5.0; }, 0.1, 0.5, no_slow_time, 3.0);
    EXPECT_NEAR(sound.at(bounded.now, 0.05, {.upright = 0.1}), 3.0, 1e-6);
}

}  // namespace
}  // namespace riffle
