#pragma once

#include "sph/pair_loops.hpp"
#include "sph/peak_rate.hpp"

namespace riffle::inline sph {

/// What each instruction set's objects of the pair loops offer.
struct LoopTable {
    PairLoops<2, float> (*plane_single)(const LoopOptions&);
    PairLoops<2, double> (*plane_double)(const LoopOptions&);
    PairLoops<3, float> (*space_single)(const LoopOptions&);
    PairLoops<3, double> (*space_double)(const LoopOptions&);
    PeakLoop peak;
};

/// The table of an instruction set, which must be available (instruction_set_available).
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

}  // namespace riffle::inline sph
