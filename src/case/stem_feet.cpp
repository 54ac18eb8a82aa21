#include "case/stem_feet.hpp"

#include <algorithm>
#include <limits>

#include "case/gauge_face.hpp"
#include "case/outline.hpp"
#include "case/solid_mesh.hpp"

namespace riffle {

namespace {

void raise(std::optional<double>& top, double z) { top = std::max(top.value_or(z), z); }

std::optional<double> top_of_outline(const Outline& outline, double x) {
    std::optional<double> top;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const double along = outline.x[j] - outline.x[i];
        if (x < std::min(outline.x[i], outline.x[j]) || x > std::max(outline.x[i], outline.x[j])) {
            continue;
        }
        if (along == 0.0) {
            raise(top, std::max(outline.z[i], outline.z[j]));
        } else {
            raise(top, outline.z[i] + (x - outline.x[i]) / along * (outline.z[j] - outline.z[i]));
        }
    }
    return top;
}

/// Of a triangle that the upright line at (x, y) meets, the height where it does.
void raise_to_triangle(std::optional<double>& top, const Triangle& t, double x, double y) {
    const Point3 normal = normal_of(t);
    if (normal[2] <= 0.0) {
        return;  // upright, or seen from below
    }
    for (std::size_t i = 0; i < t.size(); ++i) {
        const Point3& a = t[i];
        const Point3& b = t[(i + 1) % t.size()];
        if ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) < 0.0) {
            return;
        }
    }
    raise(top, t[0][2] - (normal[0] * (x - t[0][0]) + normal[1] * (y - t[0][1])) / normal[2]);
}

}  // namespace

std::optional<double> solid_top(const Case& c, const Solid& solid, double x, double y) {
    std::optional<double> top;
    if (c.channel.dimensions == 2) {
        const Outline outline{solid.x, solid.z};
        const double period = c.channel.ends == Ends::periodic ? c.channel.length : 0.0;
        const auto raise_at = [&](double place) {
            if (const auto found = top_of_outline(outline, place)) raise(top, *found);
            return false;
        };
        (void)at_any_image(x, period, raise_at);
        return top;
    }
    if (const SolidMesh* const mesh = mesh_of(c, solid)) {
        constexpr double far = std::numeric_limits<double>::infinity();
        const TriangleTree& tree = mesh->tree();
        tree.in_box({x, y, -far}, {x, y, far},
                    [&](std::size_t triangle) { raise_to_triangle(top, tree.triangles()[triangle], x, y); });
    }
    return top;
}

double stem_foot(const Case& c, const Vegetation& stems, double x, double y) {
    if (stems.stands_on.empty()) {
        return 0.0;
    }
    const auto solid = solid_named(c, stems.stands_on);
    return solid ? std::max(0.0, solid_top(c, c.solids[*solid], x, y).value_or(0.0)) : 0.0;
}

}  // namespace riffle
