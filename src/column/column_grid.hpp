#pragma once

#include <vector>

#include "case/case.hpp"

namespace riffle {

/// Finite-volume grid of the column over 0 <= z <= H, m. Faces stand at every height where a coefficient of
/// the momentum balance has a kink, a jump or a root: the zero of the mixing length, the plateau of the
/// ramp, the datum, the crest. Between two such heights the faces are cosine-spaced, dense at both ends,
/// where a logarithm, a viscous layer or the root of the drag at the crest may begin.
struct ColumnGrid {
    std::vector<double> face;    ///< n + 1 heights, from 0 to H
    std::vector<double> centre;  ///< n heights, midway between the faces
};

/// Grid of about `cells` cells. Throws InputError unless 0 <= datum < H.
[[nodiscard]] ColumnGrid make_column_grid(const Case& c, int cells);

}  // namespace riffle
