#pragma once

#include <array>
#include <vector>

namespace riffle::inline case_file {

/// A point in space, m.
using Point3 = std::array<double, 3>;

/// Its corners stand against the clock as seen from outside of the body whose surface it is part of.
using Triangle = std::array<Point3, 3>;
using Triangles = std::vector<Triangle>;

[[nodiscard]] inline Point3 minus(const Point3& a, const Point3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

[[nodiscard]] inline double dot(const Point3& a, const Point3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline Point3 cross(const Point3& a, const Point3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Twice its area along its outward normal; zero where the corners lie on a line.
[[nodiscard]] inline Point3 normal_of(const Triangle& t) {
    return cross(minus(t[1], t[0]), minus(t[2], t[0]));
}

/// Into how many parts the longest edge of a triangle is cut so that none is longer than `apart`, m.
[[nodiscard]] int parts_of_edges(const Triangle& t, double apart);

/// The place of a triangle that is nearest to a point: the foot of the perpendicular on its plane where that
/// lies in it, else the nearest place of its edges.
[[nodiscard]] Point3 nearest_on(const Triangle& t, const Point3& p);

}  // namespace riffle::inline case_file
