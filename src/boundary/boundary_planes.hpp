#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "case/case.hpp"
#include "particles/domain.hpp"

namespace riffle::inline boundary {

/// A plane wall of a channel: bed, lid, end wall, side wall or the plane of symmetry in half of a channel.
struct BoundaryPlane {
    std::size_t axis = 0;  ///< across which it stands
    double place = 0.0;    ///< coordinate along that axis, m
    double inward = 1.0;   ///< 1: the water has larger coordinates; -1: smaller ones
    double top = std::numeric_limits<double>::infinity();  ///< height up to which it stands, m
    double end = std::numeric_limits<double>::infinity();  ///< x up to which it stands, m

    /// How far a place is before it, m; below zero behind it.
    template <int D>
    [[nodiscard]] double distance(const Vec<D>& x) const {
        return inward * (x[axis] - place);
    }
};

/// The plane walls of a case in D dimensions, whatever stands on them: the bed, then the lid, the end walls
/// and the side walls. None in a box that repeats itself upward.
template <int D>
[[nodiscard]] std::vector<BoundaryPlane> boundary_planes(const Case& c);

}  // namespace riffle::inline boundary
