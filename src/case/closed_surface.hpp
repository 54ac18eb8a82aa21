#pragma once

#include <cstddef>
#include <string>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// Corners of a surface closer to each other than this share of the diagonal of the box around it are one.
/// Files hold six or seven digits, and programs that write them round shared corners one by one.
inline constexpr double weld_tolerance = 1e-6;

/// The surface of a body, its triangles turned outward.
struct ClosedSurface {
    Triangles triangles;
    std::size_t shells = 0;  ///< closed parts that have no edge in common
};

/// A closed surface from triangles as a file gives them; `name` stands for the file in messages.
/// Corners within weld_tolerance become one, and triangles that two of their corners so fall together in are
/// left out: they have no area. The surface may consist of several shells, which may lie in and through each
/// other, but none crosses itself. Shells that are turned inside out are turned, but for one that lies wholly
/// in another: that is the wall of a hollow. FileError names the triangle: a coordinate that is not a finite
/// number in single precision, an edge without a neighbour (the surface is not closed), a triangle turned
/// against its neighbour, one that passes through another one of its shell by more than weld_tolerance, no
/// triangle with an area.
[[nodiscard]] ClosedSurface closed_surface(Triangles triangles, const std::string& name);

}  // namespace riffle::inline case_file
