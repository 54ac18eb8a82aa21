#include "boundary/surface_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "boundary/solid_fill.hpp"
#include "boundary/solid_surface.hpp"
#include "case/solid_mesh.hpp"
#include "case/triangle.hpp"

namespace riffle::inline boundary {

namespace {

/// Whether water can stand before a piece of the surface.
class Before {
  public:
    Before(const Case& c, double size)
        : surfaces_(c),
          distance_(1e-3 * size),
          length_(c.channel.ends == Ends::walls ? c.channel.length : 0.0),
          width_(c.channel.dimensions == 3 && c.channel.sides != Sides::periodic ? c.channel.simulated_width()
                                                                                 : 0.0) {}

    [[nodiscard]] bool operator()(const SurfacePiece& piece) const {
        const double area = std::hypot(piece.area[0], piece.area[1], piece.area[2]);
        Vec<3> place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = piece.place[k] + distance_ * piece.area[k] / area;
        if (place[2] < distance_ || !within(place[0], length_) || !within(place[1], width_)) return false;
        for (std::size_t solid = 0; solid < surfaces_.size(); ++solid) {
            if (surfaces_.contains(solid, place)) return false;
        }
        return true;
    }

  private:
    /// Of walls at 0 and `extent`, where there are any.
    [[nodiscard]] bool within(double x, double extent) const {
        return extent <= 0.0 || (x > distance_ && x < extent - distance_);
    }

    SolidSurfaces surfaces_;
    double distance_;
    double length_;
    double width_;
};

void cut_outline(const Outline& outline, double size, std::vector<SurfacePiece>& pieces) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t end = outline.next(i);
        const double dx = outline.x[end] - outline.x[i];
        const double dz = outline.z[end] - outline.z[i];
        const double parts = std::max(1.0, std::ceil(std::hypot(dx, dz) / size));
        for (double part = 0.5; part < parts; part += 1.0) {
            // outline_of() has the solid on the left of its edges.
            pieces.push_back(
                {.place = {outline.x[i] + dx * part / parts, 0.0, outline.z[i] + dz * part / parts},
                 .area = {dz / parts, 0.0, -dx / parts}});
        }
    }
}

/// Halves a triangle across its longest edge until it is small.
void cut_triangle(const Triangle& t, double size, std::vector<SurfacePiece>& pieces) {
    std::size_t longest = 0;
    double length = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point3& a = t[i];
        const Point3& b = t[(i + 1) % 3];
        const double edge = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        if (edge > length) {
            longest = i;
            length = edge;
        }
    }
    if (length <= 0.0) return;
    const Point3& a = t[longest];
    const Point3& b = t[(longest + 1) % 3];
    const Point3& c = t[(longest + 2) % 3];
    if (length > size) {
        Point3 middle{};
        for (std::size_t k = 0; k < 3; ++k) middle[k] = 0.5 * (a[k] + b[k]);
        cut_triangle({a, middle, c}, size, pieces);
        cut_triangle({middle, b, c}, size, pieces);
        return;
    }
    SurfacePiece piece;
    const Point3 twice = normal_of(t);
    for (std::size_t k = 0; k < 3; ++k) {
        piece.place[k] = (a[k] + b[k] + c[k]) / 3.0;
        piece.area[k] = 0.5 * twice[k];
    }
    pieces.push_back(piece);
}

}  // namespace

std::vector<SurfacePiece> surface_pieces(const Case& c, std::size_t solid, double size) {
    std::vector<SurfacePiece> pieces;
    if (c.channel.dimensions == 2) {
        cut_outline(outline_of(c.solids[solid]), size, pieces);
    } else {
        const auto meshes = meshes_of(c);
        for (const Triangle& t : (*meshes)[solid].tree().triangles()) cut_triangle(t, size, pieces);
    }
    const Before water(c, size);
    std::erase_if(pieces, [&](const SurfacePiece& piece) { return piece.area == Vec<3>{} || !water(piece); });
    return pieces;
}

}  // namespace riffle::inline boundary
