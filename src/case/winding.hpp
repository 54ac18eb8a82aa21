#pragma once

#include <algorithm>
#include <limits>

#include "case/triangle_tree.hpp"

namespace riffle::inline case_file {

/// How often a triangle, seen from above, goes around the vertical line at (x, y): 1 against the clock, -1
/// with it, 0 not at all. Neighbours decide about their common edge by the same arithmetic, so that a line
/// through it passes exactly one of them.
[[nodiscard]] inline int turns_around(const Triangle& t, double x, double y) {
    int turns = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3& a = t[k];
        const Point3& b = t[(k + 1) % 3];
        const bool up = b[1] > y;
        if ((a[1] > y) == up) continue;
        const Point3& low = up ? a : b;
        const Point3& high = up ? b : a;
        const bool left = (high[0] - low[0]) * (y - low[1]) - (high[1] - low[1]) * (x - low[0]) > 0.0;
        turns += left ? (up ? 1 : -1) : 0;
    }
    return turns;
}

/// Height at which the vertical line at (x, y) passes a triangle that goes around it, m.
[[nodiscard]] inline double height_at(const Triangle& t, double x, double y) {
    const auto side = [&](const Point3& a, const Point3& b) {
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    const double s0 = side(t[1], t[2]);
    const double s1 = side(t[2], t[0]);
    const double s2 = side(t[0], t[1]);
    const auto [low, high] = std::minmax({t[0][2], t[1][2], t[2][2]});
    const double sum = s0 + s1 + s2;
    return sum == 0.0 ? high : std::clamp((s0 * t[0][2] + s1 * t[1][2] + s2 * t[2][2]) / sum, low, high);
}

/// How often a closed surface, of those triangles that `accept(triangle)` takes, goes around a point: 1 in a
/// body, 2 where two shells overlap, 0 outside and in a hollow. It is the sum over the passes of the line
/// upward from the point; the line stands beside the point by a billionth of the body's size, since points
/// and corners often stand on the same round numbers.
template <class Accept>
[[nodiscard]] int winding_number(const TriangleTree& tree, const Point3& p, const Accept& accept) {
    const double x = p[0] + 1.234567e-9 * (tree.upper()[0] - tree.lower()[0]);
    const double y = p[1] + 2.718282e-9 * (tree.upper()[1] - tree.lower()[1]);
    int sum = 0;
    tree.in_box({x, y, p[2]}, {x, y, std::numeric_limits<double>::infinity()}, [&](std::size_t i) {
        if (!accept(i)) return;
        const Triangle& t = tree.triangles()[i];
        const int turns = turns_around(t, x, y);
        sum += turns != 0 && height_at(t, x, y) > p[2] ? turns : 0;
    });
    return sum;
}

}  // namespace riffle::inline case_file
