#pragma once

#include "case/case.hpp"

namespace riffle::inline sweep {

/// What a run will take, in a unit that only serves to compare runs on one machine.
struct RunCost {
    double work = 0.0;      ///< pairs of neighbours times steps to end_time
    double end_time = 0.0;  ///< simulated: the given time, or the earliest end of a run until convergence, s
};

/// Estimate it from the case alone, without particles.
[[nodiscard]] RunCost estimate_cost(const Case& c);

}  // namespace riffle::inline sweep
