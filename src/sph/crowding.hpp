#pragma once

#include <algorithm>

namespace riffle::inline sph {

/// From here on particles are crowded: by the sum of V W over a particle and its neighbours in the water,
/// there is more water around it than there is room. The sum is 1 in the water and less at its surface and at
/// walls, whose particles it leaves out; 99 of 100 particles of a breaking dam have less than 1.05.
inline constexpr double crowding_begin = 1.15;

/// The same with the particles of the walls: in still water 1 up to the walls. Where a solid that moves meets
/// a wall, particles come so near to both that diffusion takes their surplus of density before pressure can
/// part them: what is crowded by a fifth is heavier than the water by a fifth and sinks along the edge.
inline constexpr double crowding_begin_with_walls = 1.05;

/// Steps from one look at the crowds to the next: an impact drives particles together within some tens.
inline constexpr int crowding_interval = 8;

/// The same along the edges between bed and side walls, where crowds take a thousand steps to gather.
inline constexpr int crowding_interval_along_edges = 64;

/// What the density of a particle with this sum gains beside the continuity equation, in units of c0/h: the
/// pressure that follows drives the crowd apart within some hundred h/c0. An impact drives particles together
/// and contact with a wall moves them, without their densities' knowing; suction then draws them to one
/// place, where no pair sum parts them and the sound of the water around is too fast for the step.
inline double crowding_rate(double fill) { return 0.01 * std::clamp(fill - crowding_begin, 0.0, 1.0); }
inline double crowding_rate_with_walls(double fill) {
    return 0.01 * std::clamp(fill - crowding_begin_with_walls, 0.0, 1.0);
}

}  // namespace riffle::inline sph
