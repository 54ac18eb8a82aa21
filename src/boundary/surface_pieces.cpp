#include "boundary/surface_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boundary/solid_fill.hpp"
#include "boundary/solid_surface.hpp"
#include "case/outline_check.hpp"
#include "case/solid_mesh.hpp"
#include "case/triangle.hpp"

namespace riffle::inline boundary {

namespace {

/// Whether water can stand before a piece of the surface.
class Before {
  public:
    Before(const Case& c, std::size_t solid, double size) : surfaces_(c), distance_(1e-3 * size) {
        const bool space = c.channel.dimensions == 3;
        const std::array<bool, 2> walled{c.channel.ends == Ends::walls,
                                         space && c.channel.sides != Sides::periodic};
        const std::array<bool, 2> repeats{c.channel.ends == Ends::periodic, space && !walled[1]};
        const std::array<double, 2> length{c.channel.length, space ? c.channel.simulated_width() : 0.0};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (axis == 1 && !space) continue;
            // A body that lies across periodic ends has its parts where they are drawn; one as long as the
            // channel repeats itself.
            const auto extent = extent_of(c, c.solids[solid], axis);
            const bool overhangs = extent && extent->high - extent->low >= length[axis] * (1.0 - 1e-9);
            if (repeats[axis] && !overhangs) continue;
            bounds_[axis] = {.low = walled[axis] ? distance_ : 0.0,
                             .high = length[axis] - (walled[axis] ? distance_ : 0.0)};
        }
    }

    /// Whether places on both sides of an end of the channel, or of its side, lie in a stretch along an axis.
    [[nodiscard]] bool cuts(std::size_t axis, double low, double high) const {
        return (low < bounds_[axis].low && high > bounds_[axis].low) ||
               (low < bounds_[axis].high && high > bounds_[axis].high);
    }
    /// The ends of the channel.
    [[nodiscard]] std::array<double, 2> ends() const { return {bounds_[0].low, bounds_[0].high}; }

    [[nodiscard]] bool operator()(const SurfacePiece& piece) const {
        const double area = std::hypot(piece.area[0], piece.area[1], piece.area[2]);
        Vec<3> place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = piece.place[k] + distance_ * piece.area[k] / area;
        // A face level with the bed lies on it.
        if (place[2] <= 1.5 * distance_) return false;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (!(place[axis] >= bounds_[axis].low && place[axis] < bounds_[axis].high)) return false;
        }
        for (std::size_t solid = 0; solid < surfaces_.size(); ++solid) {
            if (surfaces_.contains(solid, place)) return false;
        }
        return true;
    }

  private:
    struct Bounds {
        double low = -std::numeric_limits<double>::infinity();
        double high = std::numeric_limits<double>::infinity();
    };
    SolidSurfaces surfaces_;
    double distance_;
    std::array<Bounds, 2> bounds_{};  ///< along the channel and across it
};

void cut_outline(const Outline& outline, const Before& water, double size,
                 std::vector<SurfacePiece>& pieces) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t end = outline.next(i);
        const double dx = outline.x[end] - outline.x[i];
        const double dz = outline.z[end] - outline.z[i];
        // At the ends of the channel an edge is cut.
        std::vector<double> cuts{0.0, 1.0};
        for (const double x : water.ends()) {
            const double share = (x - outline.x[i]) / dx;
            if (std::isfinite(share) && share > 0.0 && share < 1.0) cuts.push_back(share);
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t cut = 0; cut + 1 < cuts.size(); ++cut) {
            const double whole = cuts[cut + 1] - cuts[cut];
            const double parts = std::max(1.0, std::ceil(whole * std::hypot(dx, dz) / size));
            for (double part = 0.5; part < parts; part += 1.0) {
                const double at = cuts[cut] + whole * part / parts;
                // outline_of() has the solid on the left of its edges.
                pieces.push_back({.place = {outline.x[i] + dx * at, 0.0, outline.z[i] + dz * at},
                                  .area = {dz * whole / parts, 0.0, -dx * whole / parts}});
            }
        }
    }
}

/// Halves a triangle across its longest edge until it is small, smaller where an end of the channel cuts it.
void cut_triangle(const Triangle& t, const Before& water, double size, std::vector<SurfacePiece>& pieces) {
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
    constexpr double finer = 0.1;
    bool is_cut = false;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
        is_cut = is_cut || water.cuts(axis, low, high);
    }
    if (length > (is_cut ? finer * size : size)) {
        Point3 middle{};
        for (std::size_t k = 0; k < 3; ++k) middle[k] = 0.5 * (a[k] + b[k]);
        cut_triangle({a, middle, c}, water, size, pieces);
        cut_triangle({middle, b, c}, water, size, pieces);
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
    const Before water(c, solid, size);
    if (c.channel.dimensions == 2) {
        cut_outline(outline_of(c.solids[solid]), water, size, pieces);
    } else {
        const auto meshes = meshes_of(c);
        for (const Triangle& t : (*meshes)[solid].tree().triangles()) cut_triangle(t, water, size, pieces);
    }
    std::erase_if(pieces, [&](const SurfacePiece& piece) { return piece.area == Vec<3>{} || !water(piece); });
    return pieces;
}

}  // namespace riffle::inline boundary
