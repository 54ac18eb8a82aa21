#pragma once

#include "sph/neighbour_list.hpp"
#include "sph/particle_loops.hpp"

namespace riffle::inline sph {

/// What each instruction set's objects beside the pair loops offer.
struct ParticleLoopTable {
    NeighbourSearchFunction<2> plane_search;
    NeighbourSearchFunction<3> space_search;
    ParticleLoops<2, float> plane_single;
    ParticleLoops<2, double> plane_double;
    ParticleLoops<3, float> space_single;
    ParticleLoops<3, double> space_double;
};

namespace baseline {
ParticleLoopTable particle_loop_table();
}
namespace avx2 {
ParticleLoopTable particle_loop_table();
}
namespace avx512 {
ParticleLoopTable particle_loop_table();
}

}  // namespace riffle::inline sph
