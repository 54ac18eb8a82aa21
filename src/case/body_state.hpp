#pragma once

#include <array>
#include <cmath>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// A turn as a matrix, row after row.
using Rotation = std::array<double, 9>;
inline constexpr Rotation no_rotation{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

/// The turn by an angle about an axis of length 1 (Rodrigues' formula), against the clock for who looks
/// against the axis: about y it takes z to x.
[[nodiscard]] inline Rotation rotation_about(const Point3& axis, double angle) {
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const auto [x, y, z] = axis;
    const double rest = 1.0 - cosine;
    return {cosine + x * x * rest,   x * y * rest - z * sine, x * z * rest + y * sine,
            y * x * rest + z * sine, cosine + y * y * rest,   y * z * rest - x * sine,
            z * x * rest - y * sine, z * y * rest + x * sine, cosine + z * z * rest};
}

/// Where a body is against its place at t = 0, and how it moves; SI. In two dimensions it turns about y: a
/// positive angle turns z towards x.
struct BodyState {
    Point3 displacement{};  ///< of its centre
    Point3 velocity{};      ///< so
    Point3 acceleration{};  ///< so
    bool turns = false;     ///< else it does not use what follows
    Point3 centre{};        ///< the point about which it turns, at t = 0
    Rotation rotation = no_rotation;
    Point3 angular_velocity{};      ///< rad/s
    Point3 angular_acceleration{};  ///< rad/s2

    /// A direction of the body as it is turned now.
    [[nodiscard]] Point3 turned(const Point3& v) const;
    /// A direction as the body had it at t = 0.
    [[nodiscard]] Point3 turned_back(const Point3& v) const;
    /// Where a point of the body stands that was at `place` at t = 0.
    [[nodiscard]] Point3 placed(const Point3& place) const;
    /// Where a point stood at t = 0 that moves with the body.
    [[nodiscard]] Point3 place_at_start(const Point3& point) const;
    /// Velocity of the body at a point, m/s.
    [[nodiscard]] Point3 velocity_at(const Point3& point) const;
    /// Acceleration of the body at a point, m/s2.
    [[nodiscard]] Point3 acceleration_at(const Point3& point) const;

  private:
    /// A point from the centre as it is now.
    [[nodiscard]] Point3 arm(const Point3& point) const;
};

inline Point3 BodyState::turned(const Point3& v) const {
    return turns ? Point3{rotation[0] * v[0] + rotation[1] * v[1] + rotation[2] * v[2],
                          rotation[3] * v[0] + rotation[4] * v[1] + rotation[5] * v[2],
                          rotation[6] * v[0] + rotation[7] * v[1] + rotation[8] * v[2]}
                 : v;
}

inline Point3 BodyState::turned_back(const Point3& v) const {
    return turns ? Point3{rotation[0] * v[0] + rotation[3] * v[1] + rotation[6] * v[2],
                          rotation[1] * v[0] + rotation[4] * v[1] + rotation[7] * v[2],
                          rotation[2] * v[0] + rotation[5] * v[1] + rotation[8] * v[2]}
                 : v;
}

inline Point3 BodyState::arm(const Point3& point) const {
    return {point[0] - centre[0] - displacement[0], point[1] - centre[1] - displacement[1],
            point[2] - centre[2] - displacement[2]};
}

inline Point3 BodyState::placed(const Point3& place) const {
    if (!turns) {
        return {place[0] + displacement[0], place[1] + displacement[1], place[2] + displacement[2]};
    }
    const Point3 r = turned({place[0] - centre[0], place[1] - centre[1], place[2] - centre[2]});
    return {centre[0] + displacement[0] + r[0], centre[1] + displacement[1] + r[1],
            centre[2] + displacement[2] + r[2]};
}

inline Point3 BodyState::place_at_start(const Point3& point) const {
    if (!turns) {
        return {point[0] - displacement[0], point[1] - displacement[1], point[2] - displacement[2]};
    }
    const Point3 r = turned_back(arm(point));
    return {centre[0] + r[0], centre[1] + r[1], centre[2] + r[2]};
}

inline Point3 BodyState::velocity_at(const Point3& point) const {
    if (!turns) return velocity;
    const Point3 spin = cross(angular_velocity, arm(point));
    return {velocity[0] + spin[0], velocity[1] + spin[1], velocity[2] + spin[2]};
}

inline Point3 BodyState::acceleration_at(const Point3& point) const {
    if (!turns) return acceleration;
    const Point3 r = arm(point);
    const Point3 around = cross(angular_velocity, cross(angular_velocity, r));
    const Point3 along = cross(angular_acceleration, r);
    return {acceleration[0] + around[0] + along[0], acceleration[1] + around[1] + along[1],
            acceleration[2] + around[2] + along[2]};
}

}  // namespace riffle::inline case_file
