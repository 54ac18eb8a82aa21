#pragma once

#include <cstdint>

#include "sph/pair_loops.hpp"

namespace riffle::inline sph {

/// Largest rate of single-precision multiply-adds that one core reaches with an instruction set, measured:
/// GFLOP/s, each multiply-add counted as two operations. Independent multiply-adds on the widest registers of
/// the set, nothing loaded or stored; the baseline, which has none, multiplies and adds. The median of
/// `repetitions` runs of `seconds` each. The processor must offer the set.
[[nodiscard]] double measure_peak_rate(InstructionSet set, double seconds = 0.05, int repetitions = 5);

// One per instruction set (peak_rate_isa.cpp).

/// Do `turns` turns of independent multiply-adds; returns a result that depends on all of them.
using MultiplyAddTurns = float (*)(std::int64_t turns);
/// The function of a set, and the operations of a turn.
struct PeakLoop {
    MultiplyAddTurns run = nullptr;
    double operations_per_turn = 0.0;
};
namespace baseline {
PeakLoop peak_loop();
}
namespace avx2 {
PeakLoop peak_loop();
}
namespace avx512 {
PeakLoop peak_loop();
}

}  // namespace riffle::inline sph
