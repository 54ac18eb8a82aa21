#pragma once

#include <array>

#include "case/case.hpp"

namespace riffle {

/// How a solid moves at a time; along x, y and z, SI. In two dimensions nothing goes along y.
struct SolidMotionState {
    std::array<double, 3> displacement{};  ///< from its place at t = 0
    std::array<double, 3> velocity{};
    std::array<double, 3> acceleration{};
};

/// The prescribed motion of a solid. It rests before its start; one that oscillates is then at the middle of
/// its swing and sets off at full speed. After its stop it rests where it has come to.
[[nodiscard]] SolidMotionState solid_motion(const Solid& solid, double time);

/// Largest speed of a solid, m/s.
[[nodiscard]] double largest_speed(const Solid& solid);

}  // namespace riffle
