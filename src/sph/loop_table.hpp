#pragma once

#include "sph/pair_loops.hpp"
#include "sph/particle_loops.hpp"
#include "sph/peak_rate.hpp"

namespace riffle {

/// What each instruction set's object offers.
struct LoopTable {
    PairLoops<2, float> (*plane_single)(const LoopOptions&);
    PairLoops<2, double> (*plane_double)(const LoopOptions&);
    PairLoops<3, float> (*space_single)(const LoopOptions&);
    PairLoops<3, double> (*space_double)(const LoopOptions&);
    NeighbourSearchFunction<2> plane_search;
    NeighbourSearchFunction<3> space_search;
    ParticleLoops<2, float> plane_particles_single;
    ParticleLoops<2, double> plane_particles_double;
    ParticleLoops<3, float> space_particles_single;
    ParticleLoops<3, double> space_particles_double;
    PeakLoop peak;
};

/// The table of an instruction set, which the processor must offer (processor_offers).
[[nodiscard]] LoopTable loop_table(InstructionSet set);

namespace baseline {
LoopTable loop_table();
}
namespace avx2 {
LoopTable loop_table();
}
namespace avx512 {
LoopTable loop_table();
}

}  // namespace riffle
