#pragma once

#include "boundary/wall_motion.hpp"
#include "particles/particles.hpp"

namespace riffle::inline boundary {

/// One wall particle in two dimensions; a normal of zero: of a corner, where all motion of the water counts.
struct WallParticle {
    Vec<2> position{};
    double volume = 0.0;  ///< area, m2
    Vec<2> normal{};      ///< into the fluid
    double depth = 0.0;   ///< behind the surface, m
    std::int32_t body = resting_body;
    /// All motion of the water counts, not that along the normal alone: of solids. Water that slides along
    /// one face runs off its end or into another, and where counting began along a face it would meet the
    /// density of the whole wall at once.
    bool all_motion = false;
};

/// Append it to the walls.
inline void add_wall_particle(WallParticles<2>& wall, const WallParticle& p) {
    const auto [nx, nz] = p.normal;
    const bool corner = p.all_motion || (nx == 0.0 && nz == 0.0);
    wall.position[0].push_back(p.position[0]);
    wall.position[1].push_back(p.position[1]);
    wall.volume.push_back(p.volume);
    wall.projector[0].push_back(corner ? 1.0 : nx * nx);
    wall.projector[1].push_back(corner ? 0.0 : nx * nz);
    wall.projector[2].push_back(corner ? 0.0 : nx * nz);
    wall.projector[3].push_back(corner ? 1.0 : nz * nz);
    wall.normal[0].push_back(nx);
    wall.normal[1].push_back(nz);
    wall.depth.push_back(p.depth);
    wall.body.push_back(p.body);
}

}  // namespace riffle::inline boundary
