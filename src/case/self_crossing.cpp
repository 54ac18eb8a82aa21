#include "case/self_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace riffle::inline case_file {

namespace {

int common_corners(const Triangle& a, const Triangle& b) {
    int common = 0;
    for (const Point3& corner : a) common += std::find(b.begin(), b.end(), corner) != b.end() ? 1 : 0;
    return common;
}

Point3 between(const Point3& a, const Point3& b, double share) {
    Point3 p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + share * (b[k] - a[k]);
    return p;
}

/// What a triangle has in common with the plane of another one: a segment, where corners of it stand on both
/// sides of the plane, farther away than the tolerance.
std::optional<std::pair<Point3, Point3>> cut_by_plane(const Triangle& t, const Triangle& other,
                                                      double tolerance) {
    const Point3 normal = normal_of(other);
    const double length = std::sqrt(dot(normal, normal));
    if (length <= 0.0) return std::nullopt;
    Point3 height{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double above = dot(minus(t[k], other[0]), normal) / length;
        height[k] = std::abs(above) <= tolerance ? 0.0 : above;
    }
    const auto [least, most] = std::minmax({height[0], height[1], height[2]});
    if (least >= 0.0 || most <= 0.0) return std::nullopt;
    std::array<Point3, 2> ends{};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (height[k] == 0.0) {
            ends[found++] = t[k];
        } else if (height[k] * height[next] < 0.0) {
            ends[found++] = between(t[k], t[next], height[k] / (height[k] - height[next]));
        }
    }
    return std::pair(ends[0], ends[1]);
}

/// What two triangles have in common where they cross.
std::optional<std::pair<Point3, Point3>> crossing_line(const Triangle& a, const Triangle& b,
                                                       double tolerance) {
    const auto of_b = cut_by_plane(b, a, tolerance);
    if (!of_b) return std::nullopt;
    const auto of_a = cut_by_plane(a, b, tolerance);
    if (!of_a) return std::nullopt;
    // Both lie on the line of the two planes.
    const Point3 way = minus(of_a->second, of_a->first);
    const double length = std::sqrt(dot(way, way));
    if (length <= tolerance) return std::nullopt;
    const auto share_of = [&](const Point3& p) {
        return dot(minus(p, of_a->first), way) / (length * length);
    };
    const auto [low, high] = std::minmax({share_of(of_b->first), share_of(of_b->second)});
    const double begin = std::max(low, 0.0);
    const double end = std::min(high, 1.0);
    if ((end - begin) * length <= tolerance) return std::nullopt;
    return std::pair(between(of_a->first, of_a->second, begin), between(of_a->first, of_a->second, end));
}

/// Of length 1.
Point3 unit_normal(const Triangle& t) {
    Point3 normal = normal_of(t);
    const double length = std::sqrt(dot(normal, normal));
    for (double& component : normal) component /= length;
    return normal;
}

}  // namespace

std::optional<SelfCrossing> self_crossing(const TriangleTree& tree, double tolerance,
                                          const std::function<bool(std::size_t, std::size_t)>& compares) {
    const Triangles& triangles = tree.triangles();
    std::optional<SelfCrossing> first;
    tree.for_meeting_boxes([&](std::size_t i, std::size_t j) {
        if ((first && std::pair(i, j) > std::pair(first->first, first->second)) ||
            common_corners(triangles[i], triangles[j]) > 1 || !compares(i, j)) {
            return;
        }
        if (const auto line = crossing_line(triangles[i], triangles[j], tolerance)) {
            first = SelfCrossing{i, j, between(line->first, line->second, 0.5)};
        }
    });
    return first;
}

std::vector<Seam> seams_of(const TriangleTree& tree, double tolerance) {
    const Triangles& triangles = tree.triangles();
    std::vector<Seam> seams;
    tree.for_meeting_boxes([&](std::size_t i, std::size_t j) {
        const auto line = crossing_line(triangles[i], triangles[j], tolerance);
        if (!line) return;
        const Point3 a = unit_normal(triangles[i]);
        const Point3 b = unit_normal(triangles[j]);
        seams.push_back({line->first, line->second, {a[0] + b[0], a[1] + b[1], a[2] + b[2]}});
    });
    return seams;
}

}  // namespace riffle::inline case_file
