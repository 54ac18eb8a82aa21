#pragma once

#include <array>
#include <vector>

#include "case/body_state.hpp"
#include "case/case.hpp"

namespace riffle::inline case_file {

/// How a solid moves at a time; along x, y and z, SI. In two dimensions nothing goes along y.
struct SolidMotionState {
    std::array<double, 3> displacement{};  ///< of the point that it turns about, from its place at t = 0
    std::array<double, 3> velocity{};
    std::array<double, 3> acceleration{};
    double angle = 0.0;                 ///< about its axis, from how it stands at t = 0, rad
    double angular_velocity = 0.0;      ///< rad/s
    double angular_acceleration = 0.0;  ///< rad/s2
};

/// The prescribed motion of a solid; of a free body that it rests. It rests before its start; one that
/// oscillates is then at the middle of its swing and sets off at full speed. After its stop, or the last row
/// of its table, it rests where it has come to.
[[nodiscard]] SolidMotionState solid_motion(const Solid& solid, double time);

/// Whether a solid turns, as prescribed or freely: else its motion is a displacement alone.
[[nodiscard]] bool turns(const Case& c, const Solid& solid);

/// Direction of length 1 of the axis that a solid turns about: y unless the case says otherwise.
[[nodiscard]] std::array<double, 3> rotation_axis(const Solid& solid);

/// The corners of a solid at t = 0, m: of its outline, in three dimensions of its triangles, each as often as
/// it has them.
[[nodiscard]] std::vector<std::array<double, 3>> corners_of(const Case& c, const Solid& solid);

/// The point that a solid turns about, where it is at t = 0, m: of a free body its centre of mass.
[[nodiscard]] std::array<double, 3> rotation_point(const Case& c, const Solid& solid);

/// What does not change of the turning of a solid.
struct SolidTurning {
    bool turns = false;
    std::array<double, 3> axis{0.0, 1.0, 0.0};
    std::array<double, 3> centre{};  ///< the point that it turns about, at t = 0
};
[[nodiscard]] SolidTurning solid_turning(const Case& c, const Solid& solid);

/// Where a solid is with a state of its motion.
[[nodiscard]] BodyState body_state(const SolidMotionState& state, const SolidTurning& turning);

/// Largest speed of any place of a solid by its prescribed motion, m/s; of a free body at its start.
[[nodiscard]] double largest_speed(const Case& c, const Solid& solid);

}  // namespace riffle::inline case_file
