#pragma once

#include <cstddef>
#include <string>

#include "case/case.hpp"
#include "case/outline.hpp"
#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// How far the straight edges and flat facets of a round shape may stand from it, m: a hundredth of the
/// particle spacing.
[[nodiscard]] double facet_error(const Case& c);

/// How far the corners of a solid may stand out of the shape that it was given, m: those of a circle, a
/// cylinder or a sphere, whose area or volume it has, up to facet_error(); those of others not at all.
[[nodiscard]] double corners_outside(const Case& c, const Solid& solid);

/// Number of equal edges of a circle whose middles are no further than facet_error() from it, at least 16.
[[nodiscard]] std::size_t edges_around(const Case& c, double diameter);

/// The outline of a solid by `shape` = "rectangle" or "circle", against the clock. The polygon of a circle
/// has the circle's area.
[[nodiscard]] Outline shape_outline(const Case& c, const Solid& solid);

/// The surface of a solid by `shape` = "box", "sphere" or "cylinder". Prisms and polyhedra of round shapes
/// enclose their volume.
[[nodiscard]] Triangles shape_triangles(const Case& c, const Solid& solid);

/// A sphere of triangles whose middles are no further than `error` from it, m, and which enclose its volume.
[[nodiscard]] Triangles sphere_triangles(const Point3& centre, double diameter, double error);

/// Whether a solid has all that describes its shape: the keys, so many values of each as the case has
/// dimensions, and lengths above zero.
[[nodiscard]] bool shape_is_complete(const Case& c, const Solid& solid);

/// The number of dimensions of a shape; 0 for those that go with either.
[[nodiscard]] int dimensions_of(SolidShape shape);

/// Whether a shape lies under all of a channel, and cannot move.
[[nodiscard]] bool is_bed_shape(SolidShape shape);

}  // namespace riffle::inline case_file
