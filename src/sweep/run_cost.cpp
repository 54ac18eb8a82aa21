#include "sweep/run_cost.hpp"

#include <algorithm>
#include <cmath>

#include "engine/scheme.hpp"
#include "particles/lattice.hpp"
#include "solver/twins.hpp"

namespace riffle::inline sweep {

RunCost estimate_cost(const Case& c) {
    const Twins twins = solve_twins(c);
    const Scheme scheme = make_scheme(c, twins.column_or_null());
    RunCost cost;
    cost.end_time = c.run.time;
    const std::optional<double> relaxation_time = tested_relaxation_time(c, twins);
    if (c.run.until == RunUntil::converged && relaxation_time) {
        // The convergence test needs three relaxation times and one more of record.
        cost.end_time = std::min(c.run.time, 4.0 * *relaxation_time);
    }
    const auto particles = static_cast<double>(lattice_of(c).places());
    const double neighbours = std::pow(scheme.smoothing_length / scheme.spacing, c.channel.dimensions);
    cost.work = particles * neighbours * cost.end_time / largest_step(c, scheme);
    return cost;
}

}  // namespace riffle::inline sweep
