#include "case/solid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riffle {

namespace {

Point3 minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point3 cross(const Point3& a, const Point3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point3 along(const Point3& a, const Point3& b, double t) {
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Point3 nearest_on_edge(const Point3& p, const Point3& a, const Point3& b) {
    const Point3 edge = minus(b, a);
    return along(a, b, std::clamp(dot(minus(p, a), edge) / dot(edge, edge), 0.0, 1.0));
}

/// Foot of the perpendicular on the triangle's plane where it lies in the triangle, else the nearest place of
/// its edges.
Point3 nearest_on(const Point3& p, const std::array<Point3, 3>& t) {
    const Point3 normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const Point3& a = t[k];
        const Point3& b = t[(k + 1) % 3];
        inside = inside && dot(cross(minus(b, a), minus(p, a)), normal) >= 0.0;
    }
    if (inside) {
        const double height = dot(minus(p, t[0]), normal) / dot(normal, normal);
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

Triangles placed(const Solid& solid) {
    Triangles triangles = read_stl(solid.file);
    for (auto& triangle : triangles) {
        for (Point3& corner : triangle) {
            for (std::size_t k = 0; k < 3; ++k) {
                corner[k] = solid.scale * corner[k] + (solid.place.empty() ? 0.0 : solid.place[k]);
            }
        }
    }
    return triangles;
}

}  // namespace

SolidMesh::SolidMesh(const Solid& solid) : SolidMesh(placed(solid)) {}

SolidMesh::SolidMesh(Triangles triangles) : triangles_(std::move(triangles)) {
    lower_.fill(std::numeric_limits<double>::infinity());
    upper_.fill(-std::numeric_limits<double>::infinity());
    for (const auto& triangle : triangles_) {
        for (const Point3& corner : triangle) {
            for (std::size_t k = 0; k < 3; ++k) {
                lower_[k] = std::min(lower_[k], corner[k]);
                upper_[k] = std::max(upper_[k], corner[k]);
            }
        }
    }
}

std::vector<SolidMesh> meshes_of(const Case& c) {
    std::vector<SolidMesh> meshes;
    for (const Solid& solid : c.solids) {
        meshes.emplace_back(solid);
    }
    return meshes;
}

double SolidMesh::volume() const {
    double sum = 0.0;
    for (const auto& t : triangles_) {
        sum += dot(t[0], cross(t[1], t[2])) / 6.0;
    }
    return sum;
}

// Crossings of the line upward, beside the point by less than any particle can tell: so it meets no corner
// and no edge that is shared by two triangles and would count twice.
bool SolidMesh::contains(const Point3& p) const {
    for (std::size_t k = 0; k < 3; ++k) {
        if (p[k] < lower_[k] || p[k] > upper_[k]) {
            return false;
        }
    }
    const double x = p[0] + 1.234567e-9 * (upper_[0] - lower_[0]);
    const double y = p[1] + 2.718282e-9 * (upper_[1] - lower_[1]);
    bool inside = false;
    for (const auto& t : triangles_) {
        const auto side = [&](const Point3& a, const Point3& b) {
            return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        };
        const double s0 = side(t[1], t[2]);
        const double s1 = side(t[2], t[0]);
        const double s2 = side(t[0], t[1]);
        const bool through = (s0 > 0.0 && s1 > 0.0 && s2 > 0.0) || (s0 < 0.0 && s1 < 0.0 && s2 < 0.0);
        if (through && (s0 * t[0][2] + s1 * t[1][2] + s2 * t[2][2]) / (s0 + s1 + s2) > p[2]) {
            inside = !inside;
        }
    }
    return inside;
}

SolidMesh::Foot SolidMesh::nearest(const Point3& p) const {
    double least = std::numeric_limits<double>::infinity();
    Point3 foot{};
    const std::array<Point3, 3>* triangle = nullptr;
    for (const auto& t : triangles_) {
        double beside = 0.0;  // of the distance from the triangle's box
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax({t[0][k], t[1][k], t[2][k]});
            const double outside = std::max({low - p[k], p[k] - high, 0.0});
            beside += outside * outside;
        }
        if (beside >= least) {
            continue;
        }
        const Point3 q = nearest_on(p, t);
        const double squared = dot(minus(q, p), minus(q, p));
        if (squared < least) {
            least = squared;
            foot = q;
            triangle = &t;
        }
    }
    Foot result{std::sqrt(least), minus(foot, p)};
    if (least == 0.0) {
        result.direction =
            cross(minus((*triangle)[1], (*triangle)[0]), minus((*triangle)[2], (*triangle)[0]));
    }
    const double length = std::sqrt(dot(result.direction, result.direction));
    for (double& component : result.direction) {
        component /= length;
    }
    return result;
}

}  // namespace riffle
