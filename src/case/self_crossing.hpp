#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "case/triangle_tree.hpp"

namespace riffle::inline case_file {

/// Two triangles of a surface that pass through each other.
struct SelfCrossing {
    std::size_t first = 0;
    std::size_t second = 0;
    Point3 place{};  ///< the middle of what they have in common
};

/// A line along which the surfaces of two overlapping parts of a solid pass through each other.
struct Seam {
    Point3 from{};
    Point3 to{};
    Point3 outward{};  ///< sum of both outward normals, each of length 1
};

/// The seams of the triangles that cross as self_crossing() has it; of a surface whose shells do not cross
/// themselves those between its shells.
[[nodiscard]] std::vector<Seam> seams_of(const TriangleTree& tree, double tolerance);

/// The first two triangles, in their order, that cross and that `compares(i, j)` does not leave out; nothing
/// where no two do. Triangles cross where corners of each stand on both sides of the other one, farther than
/// `tolerance` from its plane, and the line that they have in common is longer than that: surfaces that touch
/// do not cross. Those with two corners in common are neighbours, and are not compared; corners are the same
/// where their coordinates are. Where surfaces cross along edges of both alone, this is not seen.
[[nodiscard]] std::optional<SelfCrossing> self_crossing(
    const TriangleTree& tree, double tolerance,
    const std::function<bool(std::size_t, std::size_t)>& compares);

}  // namespace riffle::inline case_file
