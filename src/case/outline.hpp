#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace riffle::inline case_file {

/// A closed polygon in the x-z plane by its corners, m; the last edge goes back to the first corner.
struct Outline {
    std::vector<double> x;
    std::vector<double> z;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    /// The corner after corner i.
    [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }
};

/// Enclosed area, m2; negative for corners that follow each other clockwise (x to the right, z upward).
[[nodiscard]] double signed_area(const Outline& outline);

/// Whether a point lies inside; on the outline itself the answer is either.
[[nodiscard]] bool contains(const Outline& outline, double x, double z);

/// Distance of a point from edge i, from corner i to the next one, m.
[[nodiscard]] double distance_from_edge(const Outline& outline, std::size_t i, double x, double z);

/// The place of an outline that is nearest to a point.
struct OutlinePlace {
    std::size_t edge = 0;
    double x = 0.0;         ///< m
    double z = 0.0;         ///< m
    double distance = 0.0;  ///< from the point, m
};
/// Of edges that are equally near the first; an infinite distance for an outline without corners.
[[nodiscard]] OutlinePlace nearest_on_outline(const Outline& outline, double x, double z);

/// Distance of a point from the outline, m.
[[nodiscard]] double distance_from_outline(const Outline& outline, double x, double z);

/// Two edges that cross or touch without being neighbours, or neighbours that lie on each other; an edge of
/// no length with itself. Unset for a simple polygon.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(const Outline& outline);

/// A place along a channel of a length, drawn a little into it where it lies at an end or beyond: on an edge
/// that stands at the end, a point has no side.
[[nodiscard]] double within_ends(double x, double length);

/// Whether f(x) holds for a place along a channel or for one of its images next door, where the channel is
/// periodic: `period` its length, m; 0 where it is not.
template <class F>
[[nodiscard]] bool at_any_image(double x, double period, const F& f) {
    return f(x) || (period > 0.0 && (f(x - period) || f(x + period)));
}

/// Height at which the vertical line upward from a point first leaves the outline, m; the point's own height
/// where it does not meet it.
[[nodiscard]] double ceiling_above(const Outline& outline, double x, double z);

/// The middle of edge i, m, and the unit vector at right angles to it into the outline.
struct EdgeMiddle {
    double x, z;
    double inward_x, inward_z;
};
[[nodiscard]] EdgeMiddle middle_of_edge(const Outline& outline, std::size_t i);

/// Length of the straight way into the outline from the middle of edge i, at right angles to it, up to the
/// first other edge, m.
[[nodiscard]] double thickness_at(const Outline& outline, std::size_t i);

}  // namespace riffle::inline case_file
