#pragma once

#include <array>
#include <optional>
#include <string>

#include "case/case.hpp"

namespace riffle {

/// How a solid moves at a time, in the x-z plane; SI.
struct SolidMotionState {
    std::array<double, 2> displacement{};  ///< from its place at t = 0
    std::array<double, 2> velocity{};
    std::array<double, 2> acceleration{};
};

/// The prescribed motion of a solid. It rests before its start; one that oscillates is then at the middle of
/// its swing and sets off at full speed. After its stop it rests where it has come to.
[[nodiscard]] SolidMotionState solid_motion(const Solid& solid, double time);

/// Largest speed of a solid, m/s.
[[nodiscard]] double largest_speed(const Solid& solid);

/// Two solids of which one at least moves, and the time from which they stand in each other.
struct SolidOverlap {
    std::size_t first = 0;
    std::size_t second = 0;
    double time = 0.0;
    std::array<double, 2> place{};  ///< where, x and z, m
};

/// The first overlap of solids in two dimensions up to the end of the run, deeper than a tenth of the
/// spacing: solids may touch and slide along each other. Ends that are periodic count.
[[nodiscard]] std::optional<SolidOverlap> first_overlap(const Case& c);

}  // namespace riffle
