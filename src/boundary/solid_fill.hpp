#pragma once

#include "case/case.hpp"
#include "case/outline.hpp"
#include "particles/particles.hpp"

namespace riffle::inline boundary {

/// The outline of a solid, its corners in the sense that has the solid on the left.
[[nodiscard]] Outline outline_of(const Solid& solid);

/// Whether edge i of a solid may come in touch with water: not where a solid that stands still lies against
/// the bed, an end wall or the lid, or beyond it.
[[nodiscard]] bool is_wetted(const Case& c, const Solid& solid, const Outline& outline, std::size_t i);

/// Add the dummy particles of a solid in two dimensions to the walls: layers along the inside of its wetted
/// edges, one spacing apart, the first half a spacing behind the surface, as many as `numerics.wall_layers`
/// or as the solid is thick; at a right angle those of the longer edge go through. Each particle takes the
/// normal of its edge and the area of its part of the layer, so that the layers leave no gap at a corner of
/// the solid, sharp or blunt; around a corner that the solid surrounds they are arcs, without a normal.
/// `body`: the number that the particles carry (WallParticles::body), first_solid for the first solid of the
/// case, and so on. Of solids at rest that overlap, a place in several belongs to the first: their union is
/// filled once.
void add_solid(const Case& c, const Solid& solid, std::int32_t body, WallParticles<2>& walls);

}  // namespace riffle::inline boundary
