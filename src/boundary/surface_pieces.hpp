#pragma once

#include <cstddef>
#include <vector>

#include "case/case.hpp"
#include "particles/domain.hpp"

namespace riffle::inline boundary {

/// A small part of the surface of a solid.
struct SurfacePiece {
    Vec<3> place{};  ///< its middle, m; y = 0 in two dimensions
    Vec<3> area{};   ///< times the normal away from the solid, m2; in two dimensions a length, m
};

/// Where water can touch a solid at t = 0: its surface without what lies in another solid, on the bed, or
/// beyond the walls of the channel, in pieces no longer than `size`, m.
[[nodiscard]] std::vector<SurfacePiece> surface_pieces(const Case& c, std::size_t solid, double size);

}  // namespace riffle::inline boundary
