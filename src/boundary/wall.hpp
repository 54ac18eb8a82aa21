#pragma once

#include "case/case.hpp"
#include "particles/particles.hpp"

namespace riffle {

/// How the walls of a case act on the fluid.
struct WallLaw {
    bool dynamic = false;  ///< density from the continuity equation (Dalrymple & Knio 2001), not extrapolated
    bool no_slip = false;  ///< viscous friction with the wall
};
[[nodiscard]] WallLaw wall_law(const Case& c);

/// Wall particles of a case: layers of dummy particles (Adami et al. 2012) below a bed, above a top wall
/// and behind end walls, on the continuation of the fluid's lattice; or two staggered layers of dynamic
/// particles. Empty for a fully periodic case. In three dimensions (periodic ends, free surface) layers of
/// dummy particles below the bed, behind the side walls and behind a plane of symmetry.
template <int D = 2>
[[nodiscard]] WallParticles<D> wall_particles(const Case& c);

}  // namespace riffle
