#pragma once

#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace riffle {

/// A standard workload of `riffle bench`.
struct Workload {
    std::string name;    ///< e.g. "channel-2d-5k"
    std::string scheme;  ///< "default": closure and corrected pressure; "plain": laminar, symmetric pressure
    int dimensions = 2;
    double spacing = 0.0;  ///< m
    double length = 0.0;   ///< m
    double width = 0.0;    ///< m, in three dimensions
};

/// The workloads, smallest first: flow condition 2, longer (and wider) for more particles.
[[nodiscard]] std::vector<Workload> standard_workloads();

/// Measured speed of a workload; medians over repetitions, everything of a step included.
struct BenchmarkResult {
    Workload workload;
    std::size_t particles = 0;
    int threads = 0;
    double neighbours = 0.0;              ///< counted within the kernel's support, per particle
    double listed_neighbours = 0.0;       ///< in the lists, per cluster
    double nanoseconds_per_update = 0.0;  ///< wall clock x threads, per particle force evaluation
    double updates_per_second = 0.0;      ///< all threads together
    double steps_per_list_build = 0.0;
    double bytes_per_particle = 0.0;  ///< held by the simulation's arrays
    StepProfile profile;              ///< shares of a step, each between 0 and 1
};

/// Run a workload from the column's profile: a short run-in, then `repetitions` timed parts of about
/// `seconds`.
[[nodiscard]] BenchmarkResult run_benchmark(const Workload& workload, int threads, int repetitions,
                                            double seconds);

}  // namespace riffle
