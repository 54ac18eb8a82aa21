#include "case/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riffle::inline case_file {

namespace {

struct Point {
    double x = 0.0;
    double z = 0.0;
};

Point corner(const Outline& outline, std::size_t i) { return {outline.x[i], outline.z[i]}; }

/// Twice the area of a triangle, positive where its corners turn to the left.
double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

bool between(const Point& a, const Point& b, const Point& p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.z, b.z) <= p.z &&
           p.z <= std::max(a.z, b.z);
}

/// Whether two segments have a point in common.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double c_side = turn(a, b, c);
    const double d_side = turn(a, b, d);
    const double a_side = turn(c, d, a);
    const double b_side = turn(c, d, b);
    if (((c_side > 0 && d_side < 0) || (c_side < 0 && d_side > 0)) &&
        ((a_side > 0 && b_side < 0) || (a_side < 0 && b_side > 0))) {
        return true;
    }
    return (c_side == 0 && between(a, b, c)) || (d_side == 0 && between(a, b, d)) ||
           (a_side == 0 && between(c, d, a)) || (b_side == 0 && between(c, d, b));
}

}  // namespace

double signed_area(const Outline& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        twice += outline.x[i] * outline.z[j] - outline.x[j] * outline.z[i];
    }
    return 0.5 * twice;
}

bool contains(const Outline& outline, double x, double z) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a = corner(outline, i);
        const Point b = corner(outline, outline.next(i));
        if ((a.z > z) != (b.z > z) && x < a.x + (z - a.z) / (b.z - a.z) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

namespace {

OutlinePlace nearest_on_edge(const Outline& outline, std::size_t i, double x, double z) {
    const Point a = corner(outline, i);
    const Point b = corner(outline, outline.next(i));
    const double squared = (b.x - a.x) * (b.x - a.x) + (b.z - a.z) * (b.z - a.z);
    const double t = squared > 0.0
                         ? std::clamp(((x - a.x) * (b.x - a.x) + (z - a.z) * (b.z - a.z)) / squared, 0.0, 1.0)
                         : 0.0;
    const Point place{a.x + t * (b.x - a.x), a.z + t * (b.z - a.z)};
    return {i, place.x, place.z, std::hypot(x - place.x, z - place.z)};
}

}  // namespace

double distance_from_edge(const Outline& outline, std::size_t i, double x, double z) {
    return nearest_on_edge(outline, i, x, z).distance;
}

OutlinePlace nearest_on_outline(const Outline& outline, double x, double z) {
    OutlinePlace best;
    best.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const OutlinePlace place = nearest_on_edge(outline, i, x, z);
        if (place.distance < best.distance) best = place;
    }
    return best;
}

double distance_from_outline(const Outline& outline, double x, double z) {
    return nearest_on_outline(outline, x, z).distance;
}

std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(const Outline& outline) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = corner(outline, i);
        const Point b = corner(outline, outline.next(i));
        if (a.x == b.x && a.z == b.z) return std::pair(i, i);
        for (std::size_t j = i + 1; j < n; ++j) {
            const Point c = corner(outline, j);
            const Point d = corner(outline, outline.next(j));
            bool crossed = false;
            if (outline.next(i) == j) {
                crossed = turn(a, b, d) == 0 && (a.x - b.x) * (d.x - b.x) + (a.z - b.z) * (d.z - b.z) > 0;
            } else if (outline.next(j) == i) {
                crossed = turn(c, d, b) == 0 && (c.x - d.x) * (b.x - d.x) + (c.z - d.z) * (b.z - d.z) > 0;
            } else {
                crossed = meet(a, b, c, d);
            }
            if (crossed) return std::pair(i, j);
        }
    }
    return std::nullopt;
}

double within_ends(double x, double length) {
    constexpr double inside = 1e-9;
    return std::clamp(x, inside * length, (1.0 - inside) * length);
}

double ceiling_above(const Outline& outline, double x, double z) {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a = corner(outline, i);
        const Point b = corner(outline, outline.next(i));
        if ((a.x > x) != (b.x > x)) {
            const double crossing = a.z + (x - a.x) / (b.x - a.x) * (b.z - a.z);
            if (crossing > z) lowest = std::min(lowest, crossing);
        }
    }
    return std::isfinite(lowest) ? lowest : z;
}

EdgeMiddle middle_of_edge(const Outline& outline, std::size_t i) {
    const Point a = corner(outline, i);
    const Point b = corner(outline, outline.next(i));
    const double length = std::hypot(b.x - a.x, b.z - a.z);
    const double side = signed_area(outline) > 0.0 ? 1.0 : -1.0;
    return {0.5 * (a.x + b.x), 0.5 * (a.z + b.z), -side * (b.z - a.z) / length, side * (b.x - a.x) / length};
}

double thickness_at(const Outline& outline, std::size_t i) {
    const EdgeMiddle edge = middle_of_edge(outline, i);
    const Point inward{edge.inward_x, edge.inward_z};
    const Point middle{edge.x, edge.z};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < outline.size(); ++j) {
        if (j == i) continue;
        // middle + s inward = c + t (d - c)
        const Point c = corner(outline, j);
        const Point d = corner(outline, outline.next(j));
        const double determinant = inward.x * (c.z - d.z) - inward.z * (c.x - d.x);
        if (determinant == 0.0) continue;
        const Point to_c{c.x - middle.x, c.z - middle.z};
        const double s = (to_c.x * (c.z - d.z) - to_c.z * (c.x - d.x)) / determinant;
        const double t = (inward.x * to_c.z - inward.z * to_c.x) / determinant;
        if (s > 0.0 && t >= 0.0 && t <= 1.0) least = std::min(least, s);
    }
    return least;
}

}  // namespace riffle::inline case_file
