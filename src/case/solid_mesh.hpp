#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/closed_surface.hpp"
#include "case/triangle_tree.hpp"

namespace riffle::inline case_file {

/// The closed surface of a solid in three dimensions, placed in the channel. Where several shells overlap,
/// the solid is what lies in any of them.
class SolidMesh {
  public:
    /// Of a solid of a case, whatever its shape; errors as read_mesh(), bed_heights() and closed_surface().
    /// `notes` takes what was made of data.
    SolidMesh(const Case& c, const Solid& solid, std::vector<std::string>* notes = nullptr);
    explicit SolidMesh(ClosedSurface surface);

    [[nodiscard]] const Point3& lower() const { return tree_.lower(); }
    [[nodiscard]] const Point3& upper() const { return tree_.upper(); }
    /// Enclosed volume, m3; what lies in two shells counts twice.
    [[nodiscard]] double volume() const;
    [[nodiscard]] bool contains(const Point3& p) const;

    struct Foot {
        double distance = 0.0;  ///< m
        Point3 direction{};     ///< from the point to the surface, of length 1; of a point on it the normal
    };
    /// The nearest place of the surface that water can touch: of overlapping shells no place in another one.
    /// Nothing where none is nearer than `limit`, m.
    [[nodiscard]] std::optional<Foot> nearest(const Point3& p,
                                              double limit = std::numeric_limits<double>::infinity()) const;
    /// The same of those places alone that `takes`.
    [[nodiscard]] std::optional<Foot> nearest(const Point3& p, double limit,
                                              const std::function<bool(const Point3&)>& takes) const;

    /// Its triangles, for questions of other kinds.
    [[nodiscard]] const TriangleTree& tree() const { return tree_; }

  private:
    /// Whether nothing of the solid lies just beyond a place of its surface.
    [[nodiscard]] bool is_exposed(const Point3& place, const Point3& outward) const;

    TriangleTree tree_;
    bool several_shells_ = false;
    // Where shells pass through each other: the rim of what water can touch of their faces. As triangles
    // without area, and the ways out of the solid there.
    TriangleTree seams_;
    std::vector<Point3> seams_outward_;
};

/// The surface of a solid of a case in three dimensions, where it was read with the case; otherwise nullptr.
[[nodiscard]] const SolidMesh* mesh_of(const Case& c, const Solid& solid);

/// The surfaces of the solids of a case in three dimensions, those that were read with it or else read now.
/// Errors as SolidMesh().
[[nodiscard]] std::shared_ptr<const std::vector<SolidMesh>> meshes_of(const Case& c);

/// Whether the wall particles of solids in three dimensions fill them up to their true surface: with a packed
/// start, which fills the water up to it too. Else they take places of the water's lattice, which leaves no
/// gap, and the surface is that of the lattice.
[[nodiscard]] bool walls_end_at_surface(const Case& c);

}  // namespace riffle::inline case_file
