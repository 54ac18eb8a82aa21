#pragma once

#include <optional>

#include "case/body_state.hpp"
#include "case/case.hpp"
#include "particles/force_on_solid.hpp"

namespace riffle::inline boundary {

/// A circle, a sphere or a cylinder: a turn about its axis brings it onto itself, so pressure, which pushes
/// at right angles to its face, has no moment about that axis.
struct RoundBody {
    Point3 centre{};        ///< at t = 0, m
    Point3 axis{};          ///< so, of length 1
    bool any_axis = false;  ///< through its centre: a sphere

    /// Take that moment, which sums over particles have by their disorder, out of the moments of the pressure
    /// about `point` (of the body at t = 0).
    void clear_moment(ForceOnSolid& force, const Point3& point, const BodyState& body) const;
};

/// The roundness of a solid by its shape; nothing for other shapes and for files.
[[nodiscard]] std::optional<RoundBody> round_body(const Solid& solid);

}  // namespace riffle::inline boundary
