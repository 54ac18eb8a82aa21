#pragma once

#include "case/case.hpp"
#include "particles/lattice.hpp"
#include "particles/particles.hpp"

namespace riffle::inline boundary {

/// Add the wall particles of the solids in three dimensions to the walls, as deep as there are layers: of
/// those at rest in the channel up to so many `rows` of the lattice, of those that move all of them. Each
/// takes the normal and the depth of the nearest place of its solid's surface. Up to the true surface
/// (walls_end_at_surface) a cell of the lattice that the surface cuts has a particle in the centroid of the
/// solid's part of it, with the volume of that part: faces, edges and corners have the volumes and first
/// moments of the solid itself.
void add_meshes(const Case& c, const Lattice& lattice, int rows, WallParticles<3>& walls);

/// The share of a box with edges `size` around the origin where n . x < d, for a unit vector n (Scardovelli &
/// Zaleski 2000, eq. 1 in three dimensions).
[[nodiscard]] double share_below_plane(const Vec<3>& size, const Vec<3>& n, double d);

}  // namespace riffle::inline boundary
