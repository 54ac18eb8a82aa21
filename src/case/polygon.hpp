#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// A place in a plane.
using PlanePoint = std::array<double, 2>;

/// Triangles of a simple polygon by the numbers of its corners, in its sense of rotation. Empty where it
/// crosses itself or has no area. The time goes with the square of the corners.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> polygon_triangles(
    const std::vector<PlanePoint>& corners);

/// Triangles of a polygon in space that is nearly plane, in its sense of rotation; empty as above.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> polygon_triangles(const std::vector<Point3>& corners);

}  // namespace riffle::inline case_file
