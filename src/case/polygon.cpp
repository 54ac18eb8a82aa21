#include "case/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace riffle::inline case_file {

namespace {

/// Twice the area of a triangle, positive against the clock.
double twice_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double twice_area(const std::vector<PlanePoint>& corners) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        sum += twice_area(corners.front(), corners[i], corners[(i + 1) % corners.size()]);
    }
    return sum;
}

bool is_in_triangle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& p) {
    return twice_area(a, b, p) >= 0.0 && twice_area(b, c, p) >= 0.0 && twice_area(c, a, p) >= 0.0;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> polygon_triangles(const std::vector<PlanePoint>& corners) {
    std::vector<std::array<std::size_t, 3>> triangles;
    std::vector<std::size_t> left(corners.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    const bool against_clock = twice_area(corners) > 0.0;
    if (!against_clock) std::reverse(left.begin(), left.end());
    const auto is_ear = [&](std::size_t k, double least) {
        const std::size_t a = left[(k + left.size() - 1) % left.size()];
        const std::size_t b = left[k];
        const std::size_t c = left[(k + 1) % left.size()];
        return twice_area(corners[a], corners[b], corners[c]) > least &&
               std::none_of(left.begin(), left.end(), [&](std::size_t i) {
                   return corners[i] != corners[a] && corners[i] != corners[b] && corners[i] != corners[c] &&
                          is_in_triangle(corners[a], corners[b], corners[c], corners[i]);
               });
    };
    while (left.size() > 2) {
        std::size_t ear = 0;
        while (ear < left.size() && !is_ear(ear, 0.0)) ++ear;
        if (ear == left.size()) {  // what is left may lie on a line
            ear = 0;
            while (ear < left.size() && !is_ear(ear, -1e-300)) ++ear;
            if (ear == left.size()) {
                return {};
            }
        }
        std::array<std::size_t, 3> triangle{left[(ear + left.size() - 1) % left.size()], left[ear],
                                            left[(ear + 1) % left.size()]};
        if (!against_clock) std::swap(triangle[1], triangle[2]);
        triangles.push_back(triangle);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

std::vector<std::array<std::size_t, 3>> polygon_triangles(const std::vector<Point3>& corners) {
    Point3 normal{};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Point3 part = normal_of({corners[0], corners[i], corners[i + 1]});
        for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
    }
    // Seen along the axis that its normal is nearest to, from the side that it points to.
    std::size_t along = 0;
    for (std::size_t k = 1; k < 3; ++k) along = std::abs(normal[k]) > std::abs(normal[along]) ? k : along;
    if (normal[along] == 0.0) {
        return {};
    }
    std::vector<PlanePoint> seen;
    seen.reserve(corners.size());
    for (const Point3& corner : corners) {
        seen.push_back({corner[(along + 1) % 3], corner[(along + 2) % 3]});
    }
    return polygon_triangles(seen);
}

}  // namespace riffle::inline case_file
