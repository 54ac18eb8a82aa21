#pragma once

#include <string>
#include <vector>

#include "case/bed_heights.hpp"
#include "case/case.hpp"
#include "case/outline.hpp"
#include "case/triangle.hpp"

namespace riffle::inline case_file {

// Bodies that lie under all of a channel. They reach below its floor and beyond its ends and sides by a
// spacing more than the layers of wall particles are thick, so that no edge of them is near the water; beyond
// periodic ends and sides they repeat, beyond others they go on level.

/// The closed surface of a bed in three dimensions.
[[nodiscard]] Triangles bed_triangles(const Case& c, const BedHeights& bed);

/// The outline of a bed in two dimensions, against the clock, without corners on straight lines.
[[nodiscard]] Outline bed_outline(const Case& c, const BedHeights& bed);

/// The closed surface of one cross-section all along a channel, by `y` and `levels` of a solid.
[[nodiscard]] Triangles section_triangles(const Case& c, const Solid& solid);

/// A sphere of a layer, m.
struct LaidSphere {
    Point3 centre{};
    double diameter = 0.0;
};

/// The spheres of a layer over the bed: those that reach into the channel or stand beyond its ends and sides
/// where these are periodic. Hexagonal and square lattices are stretched to a whole number of spheres along
/// periodic ends and sides. Of several sizes the larger ones are laid first.
[[nodiscard]] std::vector<LaidSphere> laid_spheres(const Case& c, const Solid& solid);

/// The closed surfaces of these spheres. `notes` takes how many there are of each size.
[[nodiscard]] Triangles sphere_layer_triangles(const Case& c, const Solid& solid,
                                               std::vector<std::string>* notes = nullptr);

}  // namespace riffle::inline case_file
