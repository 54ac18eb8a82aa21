#include "case/gauge_face.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/outline.hpp"
#include "case/solid_mesh.hpp"

namespace riffle::inline case_file {

namespace {

SurfacePlace place_on_outline(const Outline& outline, const Point3& point) {
    const OutlinePlace near = nearest_on_outline(outline, point[0], point[2]);
    const std::size_t next = outline.next(near.edge);
    const double along_x = outline.x[next] - outline.x[near.edge];
    const double along_z = outline.z[next] - outline.z[near.edge];
    const double length = std::hypot(along_x, along_z);
    return {{near.x, 0.0, near.z}, {along_z / length, 0.0, -along_x / length}, near.distance};
}

/// Two directions of length 1 in the plane that a normal stands on, at right angles.
std::array<Point3, 2> directions_across(const Point3& normal) {
    const auto least = static_cast<std::size_t>(
        std::min_element(normal.begin(), normal.end(),
                         [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        normal.begin());
    Point3 axis{};
    axis[least] = 1.0;
    Point3 first = cross(normal, axis);
    const double length = std::sqrt(dot(first, first));
    for (double& component : first) component /= length;
    return {first, cross(normal, first)};
}

/// Points that share a face of that diameter evenly, twice as fine as the particles stand; in two dimensions
/// a line, in three a disc, the points on a spiral with the golden angle between them (Vogel 1979).
std::vector<Point3> points_of_face(const Case& c, const SurfacePlace& middle, double diameter) {
    const double cells = 2.0 * diameter / c.numerics.spacing;
    std::vector<Point3> points;
    if (c.channel.dimensions == 2) {
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(cells)));
        for (std::size_t n = 0; n < count; ++n) {
            const double along =
                ((static_cast<double>(n) + 0.5) / static_cast<double>(count) - 0.5) * diameter;
            points.push_back({middle.place[0] + along * middle.normal[2], 0.0,
                              middle.place[2] - along * middle.normal[0]});
        }
        return points;
    }
    const auto [first, second] = directions_across(middle.normal);
    const auto count =
        static_cast<std::size_t>(std::max(1.0, std::ceil(0.25 * std::numbers::pi * cells * cells)));
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (std::size_t n = 0; n < count; ++n) {
        const double radius =
            0.5 * diameter * std::sqrt((static_cast<double>(n) + 0.5) / static_cast<double>(count));
        const double u = radius * std::cos(golden_angle * static_cast<double>(n));
        const double v = radius * std::sin(golden_angle * static_cast<double>(n));
        Point3 point = middle.place;
        for (std::size_t k = 0; k < 3; ++k) point[k] += u * first[k] + v * second[k];
        points.push_back(point);
    }
    return points;
}

}  // namespace

std::optional<SurfacePlace> nearest_on_solid(const Case& c, const Solid& solid, const Point3& point) {
    if (c.channel.dimensions == 2) {
        if (solid.x.size() < 3 || solid.x.size() != solid.z.size()) return std::nullopt;
        return place_on_outline({solid.x, solid.z}, point);
    }
    const SolidMesh* const mesh = mesh_of(c, solid);
    const auto foot = mesh == nullptr ? std::nullopt : mesh->nearest(point);
    if (!foot) return std::nullopt;
    SurfacePlace found{point, foot->direction, foot->distance};
    for (std::size_t k = 0; k < 3; ++k) found.place[k] += foot->distance * foot->direction[k];
    return found;
}

std::optional<SurfacePlace> place_on_walls(const Case& c, const Point3& point) {
    const double near = 1e-3 * c.numerics.spacing;
    const auto lies_at = [&](std::size_t axis, double place) {
        return std::abs(point[axis] - place) <= near;
    };
    const Channel& channel = c.channel;
    const auto on = [&](const Point3& normal) { return SurfacePlace{point, normal, 0.0}; };
    if (channel.top != Top::periodic &&
        (lies_at(2, 0.0) || (channel.top == Top::wall && lies_at(2, c.total_depth())))) {
        return on({0.0, 0.0, 1.0});
    }
    if (channel.ends == Ends::walls && (lies_at(0, 0.0) || lies_at(0, channel.length))) {
        return on({1.0, 0.0, 0.0});
    }
    if (channel.dimensions == 3 && channel.sides != Sides::periodic &&
        (lies_at(1, 0.0) || (channel.sides == Sides::walls && lies_at(1, channel.simulated_width())))) {
        return on({0.0, 1.0, 0.0});
    }
    return std::nullopt;
}

std::optional<std::size_t> solid_named(const Case& c, const std::string& name) {
    const auto found = std::find_if(c.solids.begin(), c.solids.end(),
                                    [&](const Solid& solid) { return solid.name == name; });
    if (found == c.solids.end()) return std::nullopt;
    return static_cast<std::size_t>(found - c.solids.begin());
}

std::vector<Point3> probe_points(const Case& c, const Probe& probe) {
    const auto of = [](const std::vector<double>& values, std::size_t i, double otherwise) {
        return values.empty() ? otherwise : values.size() == 1 ? values.front() : values.at(i);
    };
    std::vector<Point3> points(std::max(probe.x.size(), probe.z.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = {of(probe.x, i, 0.0), of(probe.y, i, c.channel.centreline()), of(probe.z, i, 0.0)};
    }
    return points;
}

std::optional<GaugeFace> gauge_face(const Case& c, const Probe& probe, const Point3& point) {
    if (probe.solid.empty() && probe.diameter == 0.0) {
        return GaugeFace{point, {point}};
    }
    std::optional<SurfacePlace> surface;
    if (probe.solid.empty()) {
        surface = place_on_walls(c, point);
    } else if (const auto solid = solid_named(c, probe.solid)) {
        surface = nearest_on_solid(c, c.solids[*solid], point);
    }
    if (!surface) return std::nullopt;
    return GaugeFace{surface->place, probe.diameter == 0.0 ? std::vector{surface->place}
                                                           : points_of_face(c, *surface, probe.diameter)};
}

}  // namespace riffle::inline case_file
