#pragma once

#include <memory>
#include <string>

#include "output/checkpoint_file.hpp"
#include "output/dataset.hpp"
#include "output/results_file.hpp"
#include "solver/simulation.hpp"

namespace riffle::inline solver {

/// Add the state of a simulation under `group` ("/state"): particles in double precision in their present
/// order, listed positions, walls. With the clock as attributes of the group. The arrays are read from the
/// simulation while they are written: it must not go on before.
template <int D>
void add_state(Content& content, const SimulationIn<D>& simulation);

/// The clock alone, as attributes of the group.
template <int D>
void add_clock(Content& content, const SimulationIn<D>& simulation);

/// Put the state of a checkpoint back into a simulation of the same case. Throws FileError where the
/// checkpoint does not belong to it.
template <int D>
void restore_state(const CheckpointReader& checkpoint, SimulationIn<D>& simulation);

/// A simulation that starts from the last state in the results file that the case names, `[start] kind =
/// "results"`: from its particles, or, where spacing, length or width differ, those of the case with their
/// velocity (solver/recycled_start.hpp), and its free bodies (solver/bodies_of_results.hpp). Throws
/// InputError when the file's water does not fit the case (other dimensions, sides, depth or zones, an extent
/// that is no multiple, solids elsewhere). Volumes and pressures are kept where the equation of state
/// differs.
template <int D>
[[nodiscard]] std::unique_ptr<SimulationIn<D>> simulation_from_results(const Case& c,
                                                                       const ColumnResult* column,
                                                                       const Scheme& scheme);

}  // namespace riffle::inline solver
