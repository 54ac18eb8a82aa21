#pragma once

#include <cstddef>
#include <vector>

#include "boundary/wall_motion.hpp"
#include "case/case.hpp"
#include "particles/particles.hpp"

namespace riffle::inline boundary {

/// Whether a wall particle belongs to a solid.
template <int D>
[[nodiscard]] bool is_solid(const WallParticles<D>& walls, std::size_t i) {
    return !walls.body.empty() && walls.body[i] >= first_solid;
}

/// How the walls of a case act on the fluid.
struct WallAction {
    bool dynamic = false;  ///< density from the continuity equation (Dalrymple & Knio 2001), not extrapolated
    bool no_slip = false;  ///< viscous friction with the bed, end walls and lid
    std::vector<bool> solid_no_slip;  ///< and with each solid
    bool mirror = false;              ///< The far side is a plane of symmetry, which holds no water back.

    /// Whether the water rests at a particle of the walls.
    template <int D>
    [[nodiscard]] bool rests_at(const WallParticles<D>& walls, std::size_t i) const {
        if (is_solid(walls, i)) return solid_no_slip[static_cast<std::size_t>(walls.body[i] - first_solid)];
        if constexpr (D == 3) {
            if (mirror && walls.normal[1][i] < 0.0) return false;
        }
        return no_slip;
    }
};
[[nodiscard]] WallAction wall_action(const Case& c);

/// Height up to which end walls and side walls stand, m.
[[nodiscard]] double end_wall_height(const Case& c);

/// Whether walls may stand dry at the start of a case: the water has an outline of its own, or there are
/// solids.
[[nodiscard]] bool starts_beside_dry_walls(const Case& c);

/// Wall particles of a case: layers of dummy particles (Adami et al. 2012) below a bed, above a top wall
/// and behind end walls, on the continuation of the fluid's lattice; or two staggered layers of dynamic
/// particles; and the dummy particles of the solids. Empty for a fully periodic case, and with repulsive
/// walls (repulsive_wall.hpp). In three dimensions also behind side walls and, of dummy particles, behind a
/// plane of symmetry; of solids see mesh_fill.hpp.
template <int D = 2>
[[nodiscard]] WallParticles<D> wall_particles(const Case& c);

}  // namespace riffle::inline boundary
