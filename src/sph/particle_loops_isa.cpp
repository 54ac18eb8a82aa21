// Compiled once per instruction set, RIFFLE_ISA naming it (see cmake/instruction_sets.cmake).

#include "sph/neighbour_search.hpp"
#include "sph/particle_loop_table.hpp"
#include "sph/particle_loops_impl.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

ParticleLoopTable particle_loop_table() {
    return {.plane_search = &search_neighbours<2>,
            .space_search = &search_neighbours<3>,
            .plane_single = particle_loops_of<2, float>(),
            .plane_double = particle_loops_of<2, double>(),
            .space_single = particle_loops_of<3, float>(),
            .space_double = particle_loops_of<3, double>()};
}

}  // namespace riffle::inline sph::RIFFLE_ISA
