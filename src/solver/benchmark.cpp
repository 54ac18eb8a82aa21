#include "solver/benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <numbers>

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
    c.bed.roughness_height = 0.010;
    c.numerics.spacing = workload.spacing;
    if (workload.scheme == "plain") {
        c.numerics.pressure_form = PressureForm::symmetric;
        c.numerics.velocity_gradient = VelocityGradient::plain;
        c.turbulence.closure = ClosureKind::none;
    }
    return c;
}

}  // namespace

std::vector<Workload> standard_workloads() {
    std::vector<Workload> workloads;
    for (const char* scheme : {"plain", "default"}) {
        workloads.push_back({.name = "channel-2d-5k", .scheme = scheme, .spacing = 0.0015, .length = 0.2});
        workloads.push_back({.name = "channel-2d-50k", .scheme = scheme, .spacing = 0.0015, .length = 2.0});
        workloads.push_back({.name = "channel-2d-1m", .scheme = scheme, .spacing = 0.0015, .length = 40.0});
    }
    return workloads;
}

BenchmarkResult run_benchmark(const Workload& workload, int threads, int repetitions, double seconds) {
    using Clock = std::chrono::steady_clock;
    set_thread_count(threads);
    const Case c = workload_case(workload);
    Case turbulent = c;
    turbulent.turbulence.closure = ClosureKind::ramp;
    const ColumnResult column = solve_column(turbulent);
    const auto simulation =
        make_simulation(c, &column, initial_particles(c, make_scheme(c, &column), &column));
    const auto run_for = [&](double duration) {
        const auto start = Clock::now();
        const auto first = simulation->clock().steps;
        double elapsed = 0.0;
        while (elapsed < duration) {
            simulation->step();
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
    const double ratio = c.numerics.smoothing_ratio;
    result.neighbours = std::numbers::pi * 4.0 * ratio * ratio;
    result.listed_neighbours = simulation->mean_listed_neighbours();
    const double evaluations = static_cast<double>(result.particles) * simulation->evaluations_per_step();
    result.updates_per_second = evaluations / median;
    result.nanoseconds_per_update = 1e9 * median * result.threads / evaluations;
    const auto builds = simulation->clock().list_builds - builds_before;
    result.steps_per_list_build = static_cast<double>(simulation->clock().steps - steps_before) /
                                  static_cast<double>(std::max<std::int64_t>(1, builds));
    return result;
}

}  // namespace riffle
