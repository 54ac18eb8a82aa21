#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// A place of the surface of a wall or a solid.
struct SurfacePlace {
    Point3 place{};         ///< m; y is 0 in two dimensions
    Point3 normal{};        ///< out of or into the body, of length 1
    double distance = 0.0;  ///< from where it was asked for, m
};

/// The place of the surface of a solid, where it stands at t = 0, that is nearest to a point; nothing of a
/// solid in three dimensions whose surface was not read.
[[nodiscard]] std::optional<SurfacePlace> nearest_on_solid(const Case& c, const Solid& solid,
                                                           const Point3& point);

/// The plane wall that a point lies on, up to a thousandth of the spacing: bed, lid, end or side walls.
/// Nothing where it lies on none.
[[nodiscard]] std::optional<SurfacePlace> place_on_walls(const Case& c, const Point3& point);

/// The number of the solid of that name in a case, from 0.
[[nodiscard]] std::optional<std::size_t> solid_named(const Case& c, const std::string& name);

/// The points of a probe, one for each of its x and z.
[[nodiscard]] std::vector<Point3> probe_points(const Case& c, const Probe& probe);

/// A pressure gauge where it sits at the start.
struct GaugeFace {
    Point3 middle{};             ///< m; on the surface of its solid
    std::vector<Point3> points;  ///< shares of its face of equal size; of one without a diameter its middle
};

/// The gauge of a probe at one of its points: drawn to the surface of its solid, its face in the plane that
/// touches the surface there. Nothing where it has a solid or a diameter, and no surface is there.
[[nodiscard]] std::optional<GaugeFace> gauge_face(const Case& c, const Probe& probe, const Point3& point);

}  // namespace riffle::inline case_file
