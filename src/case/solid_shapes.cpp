#include "case/solid_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "case/cross_section.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

/// Cosine and sine of an angle in degrees, exact for quarters of a turn.
std::array<double, 2> direction_of(double degrees) {
    const double quarters = degrees / 90.0;
    if (quarters == std::round(quarters)) {
        constexpr std::array<std::array<double, 2>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const double turns = quarters - 4.0 * std::floor(quarters / 4.0);
        return exact[static_cast<std::size_t>(turns)];
    }
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

/// Corners of a rectangle around the origin, against the clock, turned by an angle in degrees.
std::array<std::array<double, 2>, 4> turned_rectangle(double width, double height, double degrees) {
    const auto [cosine, sine] = direction_of(degrees);
    std::array<std::array<double, 2>, 4> corners{};
    constexpr std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const double u = 0.5 * width * signs[i][0];
        const double v = 0.5 * height * signs[i][1];
        corners[i] = {cosine * u - sine * v, sine * u + cosine * v};
    }
    return corners;
}

/// Corners of the polygon of a circle around the origin that has its area.
std::vector<std::array<double, 2>> circle_corners(std::size_t edges, double diameter) {
    const double step = 2.0 * std::numbers::pi / static_cast<double>(edges);
    const double radius = 0.5 * diameter * std::sqrt(step / std::sin(step));
    std::vector<std::array<double, 2>> corners;
    for (std::size_t i = 0; i < edges; ++i) {
        const double angle = (static_cast<double>(i) + 0.5) * step;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return corners;
}

/// The prism over a convex polygon whose corners stand against the clock as seen against the axis: axes
/// `first`, `second` and `along` follow each other as x, y and z do. `low`, `high`: of its ends.
template <class Corners>
Triangles prism(const Corners& corners, const Point3& centre, std::size_t along, double length) {
    const std::size_t first = (along + 1) % 3;
    const std::size_t second = (along + 2) % 3;
    const auto place = [&](const std::array<double, 2>& corner, double side) {
        Point3 p = centre;
        p[first] += corner[0];
        p[second] += corner[1];
        p[along] += 0.5 * side * length;
        return p;
    };
    Triangles triangles;
    const std::array<double, 2> middle{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& a = corners[i];
        const auto& b = corners[(i + 1) % corners.size()];
        triangles.push_back({place(a, -1), place(b, -1), place(b, 1)});
        triangles.push_back({place(a, -1), place(b, 1), place(a, 1)});
        triangles.push_back({place(middle, 1), place(a, 1), place(b, 1)});
        triangles.push_back({place(middle, -1), place(b, -1), place(a, -1)});
    }
    return triangles;
}

/// The faces of an icosahedron around the origin.
Triangles icosahedron() {
    const double g = std::numbers::phi;
    const std::array<Point3, 12> p{{{-1, g, 0},
                                    {1, g, 0},
                                    {-1, -g, 0},
                                    {1, -g, 0},
                                    {0, -1, g},
                                    {0, 1, g},
                                    {0, -1, -g},
                                    {0, 1, -g},
                                    {g, 0, -1},
                                    {g, 0, 1},
                                    {-g, 0, -1},
                                    {-g, 0, 1}}};
    constexpr std::array<std::array<std::size_t, 3>, 20> faces{
        {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
         {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
         {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    Triangles triangles;
    for (const auto& face : faces) {
        triangles.push_back({p[face[0]], p[face[1]], p[face[2]]});
    }
    return triangles;
}

double volume_of(const Triangles& triangles) {
    double sum = 0.0;
    for (const Triangle& t : triangles) sum += dot(t[0], cross(t[1], t[2])) / 6.0;
    return sum;
}

}  // namespace

double facet_error(const Case& c) { return 0.01 * c.numerics.spacing; }

double corners_outside(const Case& c, const Solid& solid) {
    const bool round = solid.shape == SolidShape::circle || solid.shape == SolidShape::cylinder ||
                       solid.shape == SolidShape::sphere;
    return round ? facet_error(c) : 0.0;
}

std::size_t edges_around(const Case& c, double diameter) {
    constexpr double fewest = 16.0;
    const double share = std::min(2.0 * facet_error(c) / diameter, 1.0);
    return static_cast<std::size_t>(std::ceil(std::max(fewest, std::numbers::pi / std::acos(1.0 - share))));
}

Outline shape_outline(const Case& c, const Solid& solid) {
    Outline outline;
    const auto add = [&](const std::array<double, 2>& corner) {
        outline.x.push_back(solid.centre[0] + corner[0]);
        outline.z.push_back(solid.centre[1] + corner[1]);
    };
    if (solid.shape == SolidShape::circle) {
        for (const auto& corner : circle_corners(edges_around(c, solid.diameter), solid.diameter)) {
            add(corner);
        }
    } else if (solid.shape == SolidShape::rectangle) {
        for (const auto& corner : turned_rectangle(solid.size[0], solid.size[1], solid.angle)) add(corner);
    } else {
        throw std::logic_error("no outline of a shape: " + std::string(word(solid.shape)));
    }
    return outline;
}

Triangles shape_triangles(const Case& c, const Solid& solid) {
    const Point3 centre{solid.centre[0], solid.centre[1], solid.centre[2]};
    switch (solid.shape) {
        case SolidShape::sphere:
            return sphere_triangles(centre, solid.diameter, facet_error(c));
        case SolidShape::cylinder:
            return prism(circle_corners(edges_around(c, solid.diameter), solid.diameter), centre,
                         static_cast<std::size_t>(solid.axis), solid.length);
        case SolidShape::box:
            return prism(turned_rectangle(solid.size[0], solid.size[1], solid.angle), centre, 2,
                         solid.size[2]);
        case SolidShape::free_form:
        case SolidShape::rectangle:
        case SolidShape::circle:
        case SolidShape::bed:
        case SolidShape::section:
        case SolidShape::trapezoid:
        case SolidShape::compound:
        case SolidShape::pipe:
        case SolidShape::spheres:
            break;
    }
    throw std::logic_error("no triangles of a shape: " + std::string(word(solid.shape)));
}

Triangles sphere_triangles(const Point3& centre, double diameter, double error) {
    // The faces of an icosahedron, each cut into parts^2 triangles that are pushed out onto the sphere. Their
    // edges are at most 1.2 R / parts long, their middles that squared over 6 R from the sphere.
    const double radius = 0.5 * diameter;
    const double fine = std::ceil(std::max(4.0, std::sqrt(0.24 * radius / error)));
    constexpr double finest = 300.0;
    if (!(fine <= finest)) {
        throw InputError(
            fmt::format("a sphere of {:.3g} m would need {:.2g} triangles for this particle spacing: "
                        "see its diameter and numerics.spacing",
                        diameter, 20.0 * fine * fine));
    }
    const auto parts = static_cast<std::size_t>(fine);
    Triangles triangles;
    for (const Triangle& face : icosahedron()) {
        const auto at = [&](std::size_t i, std::size_t j) {
            const double s = static_cast<double>(i) / static_cast<double>(parts);
            const double t = static_cast<double>(j) / static_cast<double>(parts);
            Point3 p{};
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = face[0][k] + s * (face[1][k] - face[0][k]) + t * (face[2][k] - face[0][k]);
            }
            const double size = std::sqrt(dot(p, p));
            for (double& x : p) x *= radius / size;
            return p;
        };
        for (std::size_t i = 0; i < parts; ++i) {
            for (std::size_t j = 0; i + j < parts; ++j) {
                triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + j + 1 < parts) {
                    triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                }
            }
        }
    }
    const double exact = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    const double stretch = std::cbrt(exact / std::abs(volume_of(triangles)));
    for (Triangle& t : triangles) {
        for (Point3& corner : t) {
            for (std::size_t k = 0; k < 3; ++k) corner[k] = centre[k] + stretch * corner[k];
        }
    }
    return triangles;
}

int dimensions_of(SolidShape shape) {
    switch (shape) {
        case SolidShape::rectangle:
        case SolidShape::circle:
            return 2;
        case SolidShape::box:
        case SolidShape::sphere:
        case SolidShape::cylinder:
        case SolidShape::section:
        case SolidShape::trapezoid:
        case SolidShape::compound:
        case SolidShape::pipe:
        case SolidShape::spheres:
            return 3;
        case SolidShape::free_form:
        case SolidShape::bed:
            break;
    }
    return 0;
}

bool is_bed_shape(SolidShape shape) {
    return shape == SolidShape::bed || is_section(shape) || shape == SolidShape::spheres;
}

bool shape_is_complete(const Case& c, const Solid& solid) {
    const auto dimensions = static_cast<std::size_t>(c.channel.dimensions);
    const int own = dimensions_of(solid.shape);
    if (own != 0 && own != c.channel.dimensions) return false;
    const bool centred = solid.centre.size() == dimensions;
    switch (solid.shape) {
        case SolidShape::box:
        case SolidShape::rectangle:
            return centred && solid.size.size() == dimensions &&
                   std::all_of(solid.size.begin(), solid.size.end(), [](double v) { return v > 0.0; });
        case SolidShape::sphere:
        case SolidShape::circle:
            return centred && solid.diameter > 0.0;
        case SolidShape::cylinder:
            return centred && solid.diameter > 0.0 && solid.length > 0.0;
        case SolidShape::bed:
            return !solid.heights.empty() && (solid.origin.empty() || solid.origin.size() == dimensions);
        case SolidShape::section:
        case SolidShape::trapezoid:
        case SolidShape::compound:
        case SolidShape::pipe:
            return section_fault(c, solid).empty();
        case SolidShape::spheres:
            return solid.diameter > 0.0;
        case SolidShape::free_form:
            break;
    }
    return dimensions == 3 ? !solid.file.empty() && (solid.place.empty() || solid.place.size() == 3)
                           : !solid.x.empty() && !solid.z.empty();
}

}  // namespace riffle::inline case_file
