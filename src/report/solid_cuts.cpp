#include "report/solid_cuts.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "record/particle_fields.hpp"

namespace riffle::inline report {

namespace {

using Point = std::pair<double, double>;  // x, z
using Segment = std::pair<Point, Point>;

/// Where the plane at y cuts a triangle, if it does.
std::optional<Segment> cut_of(const std::array<std::array<double, 3>, 3>& corners, double y) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& a = corners[k];
        const auto& b = corners[(k + 1) % 3];
        if ((a[1] > y) == (b[1] > y)) continue;
        const double share = (y - a[1]) / (b[1] - a[1]);
        points.emplace_back(a[0] + share * (b[0] - a[0]), a[2] + share * (b[2] - a[2]));
    }
    if (points.size() != 2) return std::nullopt;
    return Segment{points[0], points[1]};
}

bool meet(const Point& a, const Point& b, double tolerance) {
    return std::abs(a.first - b.first) <= tolerance && std::abs(a.second - b.second) <= tolerance;
}

/// Segments joined end to end into outlines.
std::vector<Outline> joined(std::vector<Segment> segments) {
    constexpr double tolerance = 1e-9;  // m
    std::vector<Outline> outlines;
    while (!segments.empty()) {
        std::vector<Point> chain{segments.back().first, segments.back().second};
        segments.pop_back();
        bool longer = true;
        while (longer) {
            longer = false;
            for (std::size_t i = 0; i < segments.size(); ++i) {
                const auto [a, b] = segments[i];
                if (!meet(chain.back(), a, tolerance) && !meet(chain.back(), b, tolerance)) continue;
                chain.push_back(meet(chain.back(), a, tolerance) ? b : a);
                segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(i));
                longer = true;
                break;
            }
        }
        Outline outline;
        for (const auto& [x, z] : chain) {
            outline.x.push_back(x);
            outline.z.push_back(z);
        }
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

}  // namespace

std::vector<Outline> solid_cuts(const RunResults& results, const std::string& snapshot, double y) {
    const std::vector<double> triangles = results.values(fields::solids.triangles);
    if (triangles.empty()) return {};
    std::vector<double> vertices = results.values({snapshot, fields::snapshot.solid_vertices});
    if (vertices.empty()) vertices = results.values(fields::solids.vertices);
    std::vector<Segment> segments;
    for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
        std::array<std::array<double, 3>, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto vertex = 3 * static_cast<std::size_t>(triangles[t + k]);
            if (vertex + 2 >= vertices.size()) return {};
            for (std::size_t axis = 0; axis < 3; ++axis) corners[k][axis] = vertices[vertex + axis];
        }
        if (const auto cut = cut_of(corners, y)) segments.push_back(*cut);
    }
    return joined(std::move(segments));
}

}  // namespace riffle::inline report
