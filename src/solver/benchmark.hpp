#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace riffle::inline solver {

/// A standard workload of `riffle bench`.
struct Workload {
    std::string name;    ///< e.g. "channel-2d-5k"
    std::string scheme;  ///< "default": closure and corrected pressure; "plain": laminar, symmetric pressure;
                         ///< "spheres", in 3D: the closure of Czernuszenko & Rylov over spheres at their
                         ///< places; "resolved", in 3D: eddies that the particles carry, over the same, as
                         ///< `riffle new --resolved`
    int dimensions = 2;
    double spacing = 0.0;  ///< m
    double length = 0.0;   ///< m
    double width = 0.0;    ///< m, in three dimensions
    double jitter = 0.0;   ///< random displacement of the first lattice, in spacings

    /// Whether the scheme is one for three dimensions alone.
    [[nodiscard]] bool is_spatial() const { return scheme == "spheres" || scheme == "resolved"; }
};

/// The workloads, smallest first: flow condition 2, longer (and wider) for more particles.
[[nodiscard]] std::vector<Workload> standard_workloads();

/// Number of fluid particles that a workload starts with.
[[nodiscard]] std::size_t workload_particles(const Workload& workload);

/// Memory that running a workload takes at most, bytes: the simulation, its start, and the old and new arrays
/// of a list build side by side.
[[nodiscard]] double workload_memory(const Workload& workload);

/// Measured speed of a workload; medians over repetitions, everything of a step included.
struct BenchmarkResult {
    Workload workload;
    std::size_t particles = 0;
    int threads = 0;
    double neighbours = 0.0;              ///< counted within the kernel's support, per particle
    double listed_neighbours = 0.0;       ///< in the lists, per cluster
    double evaluations_per_second = 0.0;  ///< of the force on a particle, all threads together
    double steps_per_list_build = 0.0;
    double skin = 0.0;                ///< of the lists, in smoothing lengths
    double bytes_per_particle = 0.0;  ///< held by the simulation's arrays
    StepProfile profile;              ///< shares of a step, each between 0 and 1

    /// Time of one core for the force on one particle, ns.
    [[nodiscard]] double nanoseconds_per_evaluation() const { return 1e9 * threads / evaluations_per_second; }
    /// Time of one core for one directed pair (j acts on i) within the support, ns.
    [[nodiscard]] double nanoseconds_per_pair() const { return nanoseconds_per_evaluation() / neighbours; }
    /// Directed pairs within the support, per second and core.
    [[nodiscard]] double pairs_per_second() const { return 1e9 / nanoseconds_per_pair(); }
    /// Arithmetic of the pairs within the support (sph/pair_arithmetic.hpp), GFLOP/s of one core.
    [[nodiscard]] double useful_rate() const;
};

/// Flow condition 2 (thesis Table 3.1) at the workload's size, and the twin of its column.
[[nodiscard]] Case workload_case(const Workload& workload);
[[nodiscard]] ColumnResult workload_column(const Workload& workload);

/// The simulation of a workload at its start: the profile of its column.
template <int D>
[[nodiscard]] std::unique_ptr<SimulationIn<D>> workload_simulation(const Workload& workload);

/// Run a workload from the column's profile: a short run-in, then `repetitions` timed parts of at least
/// `seconds`, each from one build of the lists to another.
[[nodiscard]] BenchmarkResult run_benchmark(const Workload& workload, int threads, int repetitions,
                                            double seconds);

}  // namespace riffle::inline solver
