#include "solver/benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/parallel.hpp"
#include "case/case.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"

namespace riffle {

namespace {

/// Flow condition 2 (thesis Table 3.1) at the workload's size.
Case workload_case(const Workload& workload) {
    Case c;
    c.title = workload.name;
    c.channel.slope = 0.004;
    c.channel.depth = 0.050;
    c.channel.length = workload.length;
    if (workload.dimensions == 3) {
        c.channel.width = workload.width;
    }
    c.bed.roughness_height = 0.010;
    c.numerics.spacing = workload.spacing;
    if (workload.scheme == "plain") {
        c.numerics.pressure_form = PressureForm::symmetric;
        c.numerics.velocity_gradient = VelocityGradient::plain;
        c.turbulence.closure = ClosureKind::none;
    }
    return c;
}

template <int D>
BenchmarkResult run_in(const Workload& workload, int repetitions, double seconds) {
    using Clock = std::chrono::steady_clock;
    const Case c = workload_case(workload);
    Case turbulent = c;
    turbulent.turbulence.closure = ClosureKind::ramp;
    const ColumnResult column = solve_column(turbulent);
    const auto simulation =
        make_simulation<D>(c, &column, initial_particles<D>(c, make_scheme(c, &column), &column));
    simulation->drop_fields();
    // Seconds per step, without the fields that only a recorder looks at.
    const auto run_for = [&](double duration) {
        const auto start = Clock::now();
        const auto first = simulation->clock().steps;
        double elapsed = 0.0;
        while (elapsed < duration) {
            simulation->step(std::numeric_limits<double>::infinity());
            elapsed = std::chrono::duration<double>(Clock::now() - start).count();
        }
        return elapsed / static_cast<double>(simulation->clock().steps - first);
    };
    run_for(0.3 * seconds);
    std::vector<double> per_step;
    const auto steps_before = simulation->clock().steps;
    const auto builds_before = simulation->clock().list_builds;
    for (int i = 0; i < repetitions; ++i) {
        per_step.push_back(run_for(seconds));
    }
    std::nth_element(per_step.begin(), per_step.begin() + repetitions / 2, per_step.end());
    const double median = per_step[static_cast<std::size_t>(repetitions / 2)];

    BenchmarkResult result;
    result.workload = workload;
    result.particles = simulation->particles().size();
    result.threads = thread_count();
    result.neighbours = simulation->count_neighbours();
    result.listed_neighbours = simulation->mean_listed_neighbours();
    const auto particles = static_cast<double>(result.particles);
    const double evaluations = particles * simulation->evaluations_per_step();
    result.updates_per_second = evaluations / median;
    result.nanoseconds_per_update = 1e9 * median * result.threads / evaluations;
    const auto builds = simulation->clock().list_builds - builds_before;
    result.steps_per_list_build = static_cast<double>(simulation->clock().steps - steps_before) /
                                  static_cast<double>(std::max<std::int64_t>(1, builds));
    result.bytes_per_particle = static_cast<double>(simulation->bytes()) / particles;

    simulation->measure_profile(true);
    run_for(seconds);
    StepProfile& share = result.profile;
    share = simulation->profile();
    for (double* part : {&share.lists, &share.gradients, &share.forces, &share.walls, &share.particles}) {
        *part /= share.total;
    }
    share.total = 1.0;
    return result;
}

}  // namespace

std::vector<Workload> standard_workloads() {
    std::vector<Workload> workloads;
    const auto plane = [&](const char* name, double length) {
        workloads.push_back({.name = name, .scheme = "", .spacing = 0.0015, .length = length});
    };
    const auto space = [&](const char* name, double length, double width) {
        workloads.push_back(
            {.name = name, .scheme = "", .dimensions = 3, .spacing = 0.002, .length = length, .width = width});
    };
    plane("channel-2d-5k", 0.2);
    plane("channel-2d-50k", 2.0);
    plane("channel-2d-1m", 40.0);
    space("channel-3d-200k", 0.16, 0.18);
    space("channel-3d-1m", 0.4, 0.36);
    space("channel-3d-8m", 1.16, 0.98);
    std::vector<Workload> all;
    for (const char* scheme : {"plain", "default"}) {
        for (Workload w : workloads) {
            w.scheme = scheme;
            all.push_back(w);
        }
    }
    return all;
}

BenchmarkResult run_benchmark(const Workload& workload, int threads, int repetitions, double seconds) {
    set_thread_count(threads);
    return workload.dimensions == 2 ? run_in<2>(workload, repetitions, seconds)
                                    : run_in<3>(workload, repetitions, seconds);
}

}  // namespace riffle
