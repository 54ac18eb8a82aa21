#pragma once

#include <array>

#include "particles/domain.hpp"

namespace riffle {

/// A turn as a matrix, row after row.
using Rotation = std::array<double, 9>;
inline constexpr Rotation no_rotation{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

/// Where a body is against its place at t = 0, and how it moves; SI. In two dimensions it turns about y: a
/// positive angle turns z towards x.
struct BodyState {
    Vec<3> displacement{};  ///< of its centre
    Vec<3> velocity{};      ///< so
    Vec<3> acceleration{};  ///< so
    bool turns = false;     ///< else it does not use what follows
    Vec<3> centre{};        ///< the point about which it turns, at t = 0
    Rotation rotation = no_rotation;
    Vec<3> angular_velocity{};      ///< rad/s
    Vec<3> angular_acceleration{};  ///< rad/s2

    /// A direction of the body as it is turned now.
    [[nodiscard]] Vec<3> turned(const Vec<3>& v) const;
    /// A direction as the body had it at t = 0.
    [[nodiscard]] Vec<3> turned_back(const Vec<3>& v) const;
    /// Where a point of the body stands that was at `place` at t = 0.
    [[nodiscard]] Vec<3> placed(const Vec<3>& place) const;
    /// Where a point stood at t = 0 that moves with the body.
    [[nodiscard]] Vec<3> place_at_start(const Vec<3>& point) const;
    /// Velocity of the body at a point, m/s.
    [[nodiscard]] Vec<3> velocity_at(const Vec<3>& point) const;
    /// Acceleration of the body at a point, m/s2.
    [[nodiscard]] Vec<3> acceleration_at(const Vec<3>& point) const;

  private:
    /// A point from the centre as it is now.
    [[nodiscard]] Vec<3> arm(const Vec<3>& point) const;
};

[[nodiscard]] inline Vec<3> vector_product(const Vec<3>& a, const Vec<3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vec<3> BodyState::turned(const Vec<3>& v) const {
    return turns ? Vec<3>{rotation[0] * v[0] + rotation[1] * v[1] + rotation[2] * v[2],
                          rotation[3] * v[0] + rotation[4] * v[1] + rotation[5] * v[2],
                          rotation[6] * v[0] + rotation[7] * v[1] + rotation[8] * v[2]}
                 : v;
}

inline Vec<3> BodyState::turned_back(const Vec<3>& v) const {
    return turns ? Vec<3>{rotation[0] * v[0] + rotation[3] * v[1] + rotation[6] * v[2],
                          rotation[1] * v[0] + rotation[4] * v[1] + rotation[7] * v[2],
                          rotation[2] * v[0] + rotation[5] * v[1] + rotation[8] * v[2]}
                 : v;
}

inline Vec<3> BodyState::arm(const Vec<3>& point) const {
    return {point[0] - centre[0] - displacement[0], point[1] - centre[1] - displacement[1],
            point[2] - centre[2] - displacement[2]};
}

inline Vec<3> BodyState::placed(const Vec<3>& place) const {
    if (!turns) {
        return {place[0] + displacement[0], place[1] + displacement[1], place[2] + displacement[2]};
    }
    const Vec<3> r = turned({place[0] - centre[0], place[1] - centre[1], place[2] - centre[2]});
    return {centre[0] + displacement[0] + r[0], centre[1] + displacement[1] + r[1],
            centre[2] + displacement[2] + r[2]};
}

inline Vec<3> BodyState::place_at_start(const Vec<3>& point) const {
    if (!turns) {
        return {point[0] - displacement[0], point[1] - displacement[1], point[2] - displacement[2]};
    }
    const Vec<3> r = turned_back(arm(point));
    return {centre[0] + r[0], centre[1] + r[1], centre[2] + r[2]};
}

inline Vec<3> BodyState::velocity_at(const Vec<3>& point) const {
    if (!turns) {
        return velocity;
    }
    const Vec<3> spin = vector_product(angular_velocity, arm(point));
    return {velocity[0] + spin[0], velocity[1] + spin[1], velocity[2] + spin[2]};
}

inline Vec<3> BodyState::acceleration_at(const Vec<3>& point) const {
    if (!turns) {
        return acceleration;
    }
    const Vec<3> r = arm(point);
    const Vec<3> around = vector_product(angular_velocity, vector_product(angular_velocity, r));
    const Vec<3> along = vector_product(angular_acceleration, r);
    return {acceleration[0] + around[0] + along[0], acceleration[1] + around[1] + along[1],
            acceleration[2] + around[2] + along[2]};
}

/// A vector of a body as one of a flow in D dimensions.
template <int D>
[[nodiscard]] Vec<D> in_flow(const Vec<3>& v) {
    if constexpr (D == 3) {
        return v;
    } else {
        return {v[0], v[2]};
    }
}

/// A vector of a flow in D dimensions as one of a body.
template <int D>
[[nodiscard]] Vec<3> in_space_of(const Vec<D>& v) {
    if constexpr (D == 3) {
        return v;
    } else {
        return {v[0], 0.0, v[1]};
    }
}

}  // namespace riffle
