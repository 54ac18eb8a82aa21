#include "case/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riffle::inline case_file {

namespace {

Point3 along(const Point3& a, const Point3& b, double t) {
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Point3 nearest_on_edge(const Point3& p, const Point3& a, const Point3& b) {
    const Point3 edge = minus(b, a);
    const double squared = dot(edge, edge);
    return squared > 0.0 ? along(a, b, std::clamp(dot(minus(p, a), edge) / squared, 0.0, 1.0)) : a;
}

}  // namespace

int parts_of_edges(const Triangle& t, double apart) {
    const Point3 a = minus(t[1], t[0]);
    const Point3 b = minus(t[2], t[0]);
    const Point3 c = minus(t[2], t[1]);
    const double longest = std::sqrt(std::max({dot(a, a), dot(b, b), dot(c, c)}));
    return std::max(1, static_cast<int>(std::ceil(longest / apart)));
}

Point3 nearest_on(const Triangle& t, const Point3& p) {
    const Point3 normal = normal_of(t);
    const double squared_normal = dot(normal, normal);
    bool inside = squared_normal > 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3& a = t[k];
        const Point3& b = t[(k + 1) % 3];
        inside = inside && dot(cross(minus(b, a), minus(p, a)), normal) >= 0.0;
    }
    if (inside) {
        const double height = dot(minus(p, t[0]), normal) / squared_normal;
        return {p[0] - height * normal[0], p[1] - height * normal[1], p[2] - height * normal[2]};
    }
    Point3 best{};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3 q = nearest_on_edge(p, t[k], t[(k + 1) % 3]);
        const double squared = dot(minus(q, p), minus(q, p));
        if (squared < least) {
            least = squared;
            best = q;
        }
    }
    return best;
}

}  // namespace riffle::inline case_file
