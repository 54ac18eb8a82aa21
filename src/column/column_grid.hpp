#pragma once

#include <vector>

#include "case/case.hpp"

namespace riffle::inline column {

/// Finite-volume grid of the column over 0 <= z <= H, m. Faces stand at every height where a coefficient of
/// the momentum balance has a kink, a jump or a root: the zero of the mixing length, the plateau of the
/// ramp, the datum, the crest. Between two such heights the faces are cosine-spaced, dense at both ends,
/// where a logarithm, a viscous layer or the root of the drag at the crest may begin.
struct ColumnGrid {
    std::vector<double> face;    ///< n + 1 heights, from 0 to H
    std::vector<double> centre;  ///< n heights, midway between the faces
};

/// Heights from 0 to H at which a coefficient of the momentum balance is not smooth, in order, m.
[[nodiscard]] std::vector<double> column_breakpoints(const Case& c);

/// Faces of about `cells` cells with a face at each of the `breakpoints` (in order) and cosine spacing
/// between them, at least `fewest` cells in each. `even` is the part of the cells that goes evenly to the
/// segments; the rest goes by their length.
[[nodiscard]] std::vector<double> graded_faces(const std::vector<double>& breakpoints, int cells, int fewest,
                                               double even = 0.5);

/// The points midway between the faces.
[[nodiscard]] std::vector<double> midpoints(const std::vector<double>& faces);

/// `points` in order between `from` and `to`, those outside left out and those that coincide but for rounding
/// taken as one.
[[nodiscard]] std::vector<double> distinct_between(std::vector<double> points, double from, double to);

/// Grid of about `cells` cells. Throws InputError unless 0 <= datum < H.
[[nodiscard]] ColumnGrid make_column_grid(const Case& c, int cells);

}  // namespace riffle::inline column
