// Compiled once per instruction set, RIFFLE_ISA naming it (see cmake/instruction_sets.cmake).

#include "sph/loop_table.hpp"
#include "sph/pair_loops_impl.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

LoopTable loop_table() {
    return {.plane_single = &loops<2, float>,
            .plane_double = &loops<2, double>,
            .space_single = &loops<3, float>,
            .space_double = &loops<3, double>,
            .peak = peak_loop()};
}

}  // namespace riffle::inline sph::RIFFLE_ISA
