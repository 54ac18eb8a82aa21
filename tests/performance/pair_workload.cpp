// A few steps of a small channel on one thread, for counting instructions. With `count` it prints the
// directed pairs within the support and the particles, both summed over the steps, and the particles summed
// over the builds of the lists.
//
// Usage: pair_workload 2|3 plain|default [count]

#include <fmt/format.h>

#include <limits>
#include <string>

#include "base/parallel.hpp"
#include "solver/benchmark.hpp"

namespace {

template <int D>
void run(const riffle::Workload& workload, bool count) {
    const auto simulation = riffle::workload_simulation<D>(workload);
    const auto particles = static_cast<double>(simulation->particles().size());
    double pairs = 0.0;
    for (int step = 0; step < 2; ++step) {
        if (count) pairs += simulation->count_neighbours() * particles;
        simulation->step(std::numeric_limits<double>::infinity());  // a step that keeps no fields, as most do
    }
    if (count) {
        const riffle::SimulationClock clock = simulation->clock();
        fmt::print("{:.0f} {:.0f} {:.0f}\n", pairs, particles * static_cast<double>(clock.steps),
                   particles * static_cast<double>(clock.list_builds));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        fmt::print(stderr, "usage: pair_workload 2|3 plain|default [count]\n");
        return 2;
    }
    const bool count = argc > 3 && std::string(argv[3]) == "count";
    riffle::set_thread_count(1);
    // The jitter: on a lattice many pairs lie at the end of the support exactly, and rounding decides whether
    // they count.
    riffle::Workload workload{.name = "guard", .scheme = argv[2], .jitter = 0.1};
    if (std::string(argv[1]) == "3") {
        workload.dimensions = 3;
        workload.spacing = 0.002;
        workload.length = 0.04;
        workload.width = 0.032;
        run<3>(workload, count);
    } else {
        workload.spacing = 0.0015;
        workload.length = 0.2;
        run<2>(workload, count);
    }
    return 0;
}
