// Compiled once per instruction set, RIFFLE_ISA naming it (see cmake/instruction_sets.cmake).

#include "sph/pair_loops_impl.hpp"

namespace riffle::RIFFLE_ISA {

PairLoops<2, float> loops_2d_single(KernelKind kernel, ViscosityForm viscosity) {
    return loops<2, float>(kernel, viscosity);
}

PairLoops<2, double> loops_2d_double(KernelKind kernel, ViscosityForm viscosity) {
    return loops<2, double>(kernel, viscosity);
}

}  // namespace riffle::RIFFLE_ISA
