#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle {

/// A point in space, m.
using Point3 = std::array<double, 3>;

/// Triangles of an STL file, in its unit, the corners against the clock as seen from outside.
using Triangles = std::vector<std::array<Point3, 3>>;

/// Read an STL file, binary or text. FileError names file and triangle: a file that is cut short, a number
/// that is none, a triangle without area, an edge without exactly one neighbour (the surface is not closed),
/// or a triangle turned against its neighbour. A surface that is turned inside out as a whole is turned.
[[nodiscard]] Triangles read_stl(const std::filesystem::path& file);

/// The closed surface of a solid in three dimensions, placed in the channel.
class SolidMesh {
  public:
    /// Of [[solid]] `file`, `scale` and `place`; errors as read_stl().
    explicit SolidMesh(const Solid& solid);
    explicit SolidMesh(Triangles triangles);

    [[nodiscard]] const Point3& lower() const { return lower_; }
    [[nodiscard]] const Point3& upper() const { return upper_; }
    /// Enclosed volume, m3.
    [[nodiscard]] double volume() const;
    [[nodiscard]] bool contains(const Point3& p) const;

    struct Foot {
        double distance = 0.0;  ///< m
        Point3 direction{};     ///< from the point to the surface, of length 1; of a point on it the normal
    };
    /// The nearest place of the surface.
    [[nodiscard]] Foot nearest(const Point3& p) const;

  private:
    Triangles triangles_;
    Point3 lower_{};
    Point3 upper_{};
};

/// The surfaces of the solids of a case in three dimensions.
[[nodiscard]] std::vector<SolidMesh> meshes_of(const Case& c);

}  // namespace riffle
