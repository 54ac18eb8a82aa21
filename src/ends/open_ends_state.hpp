#pragma once

#include <cstdint>
#include <vector>

#include "ends/outgoing_sound.hpp"

namespace riffle::inline ends {

/// What crosses the ends of the simulated water, all in all: an account of each particle.
struct EndsLedger {
    /// Particles made before the inflow less those taken out there, unentered: below zero where the water of
    /// the start was drawn back.
    std::int64_t entered = 0;
    std::int64_t left = 0;      ///< particles taken out
    double mass_entered = 0.0;  ///< kg; in two dimensions per width, kg/m
    double mass_left = 0.0;
    double momentum_entered = 0.0;  ///< along the channel, kg m/s (per m)
    double momentum_left = 0.0;

    bool operator==(const EndsLedger&) const = default;
};

/// The water at one end.
struct EndState {
    // Watched inside of the channel, smoothed in time.
    double watched_depth = 0.0;     ///< m, of the whole water
    double watched_velocity = 0.0;  ///< depth mean, m/s
    double watched_pressure = 0.0;  ///< of a duct, over the density, m2/s2
    // The section that the end follows from it.
    double depth = 0.0;
    double velocity = 0.0;
    double depth_rate = 0.0;  ///< m/s
    double pressure = 0.0;    ///< of a duct, over the density, m2/s2
    double coming = 0.0;      ///< invariant U - 2 c, of a duct U - p/(rho c0): upstream watched, downstream
                              ///< what enters, m/s

    bool operator==(const EndState&) const = default;
};

/// State of the open ends that a run needs to go on with the same bits.
struct OpenEndsState {
    bool begun = false;
    EndState upstream;
    EndState downstream;
    double travel = 0.0;  ///< largest way of water at an end since the last list build, m
    int rows = 0;         ///< streams over each other at the inflow
    std::vector<double>
        leaving;  ///< velocity of the water that leaves, smoothed in time, in bins over its depth, m/s
    std::vector<double>
        front;  ///< place of the last particle of each stream, m: by rows, within them by files
    EndsLedger ledger;
    SoundBeyondEnd sound_upstream;
    SoundBeyondEnd sound_downstream;

    /// All of it as numbers, for a checkpoint; empty where there are no open ends.
    [[nodiscard]] std::vector<double> numbers() const;
    /// From numbers(). Throws std::invalid_argument where they are not such.
    [[nodiscard]] static OpenEndsState from(const std::vector<double>& numbers);
    /// The sound at both ends as numbers, and back. Throws std::invalid_argument where they are not such.
    [[nodiscard]] std::vector<double> sound_numbers() const;
    void take_sound(const std::vector<double>& numbers);

    bool operator==(const OpenEndsState&) const = default;
};

}  // namespace riffle::inline ends
