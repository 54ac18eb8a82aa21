#include "solver/benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/parallel.hpp"
#include "case/case.hpp"
#include "case/presets.hpp"
#include "particles/lattice.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"
#include "sph/pair_arithmetic.hpp"

namespace riffle::inline solver {

Case workload_case(const Workload& workload) {
    Case c;
    c.title = workload.name;
    c.channel.slope = 0.004;
    c.channel.depth = 0.050;
    c.channel.length = workload.length;
    if (workload.dimensions == 3) {
        c.channel.dimensions = 3;
        c.channel.width = workload.width;
        c.bed.drag_form = DragForm::plan_mean;  // that of a plane
    }
    c.bed.roughness_height = 0.010;
    c.numerics.spacing = workload.spacing;
    c.start.jitter = workload.jitter;
    if (workload.scheme == "plain") {
        c.numerics.pressure_form = PressureForm::symmetric;
        c.numerics.velocity_gradient = VelocityGradient::plain;
        c.turbulence.closure = ClosureKind::none;
    }
    if (workload.scheme == "spheres") {
        c.bed.drag_form = DragForm::consistent;
        c.turbulence.closure = ClosureKind::czernuszenko_rylov;
    }
    if (workload.scheme == "resolved") {
        c.bed.drag_form = DragForm::consistent;
        choose_for_resolved_eddies(c);
    }
    return c;
}

ColumnResult workload_column(const Workload& workload) {
    Case turbulent = workload_case(workload);
    turbulent.turbulence.closure = ClosureKind::ramp;
    return solve_column(turbulent);
}

template <int D>
std::unique_ptr<SimulationIn<D>> workload_simulation(const Workload& workload) {
    const Case c = workload_case(workload);
    const ColumnResult column = workload_column(workload);
    return make_simulation<D>(c, &column, initial_particles<D>(c, make_scheme(c, &column), &column));
}

template std::unique_ptr<SimulationIn<2>> workload_simulation<2>(const Workload&);
template std::unique_ptr<SimulationIn<3>> workload_simulation<3>(const Workload&);

namespace {

template <int D>
BenchmarkResult run_in(const Workload& workload, int repetitions, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto simulation = workload_simulation<D>(workload);
    simulation->drop_fields();
    // Seconds per step, without the fields that only a recorder looks at. A part ends with a step that built
    // the lists, so that each holds whole lives of lists; where none is built any more, after enough steps.
    const auto run_for = [&](double duration) {
        constexpr std::int64_t enough = 200;
        const auto start = Clock::now();
        const SimulationClock first = simulation->clock();
        double elapsed = 0.0;
        for (bool built = false; elapsed < duration || !built;) {
            const std::int64_t builds = simulation->clock().list_builds;
            simulation->step(std::numeric_limits<double>::infinity());
            built =
                simulation->clock().list_builds > builds || simulation->clock().steps >= first.steps + enough;
            elapsed = std::chrono::duration<double>(Clock::now() - start).count();
        }
        return elapsed / static_cast<double>(simulation->clock().steps - first.steps);
    };
    run_for(0.3 * seconds);
    std::vector<double> per_step;
    per_step.reserve(static_cast<std::size_t>(repetitions));
    const auto steps_before = simulation->clock().steps;
    const auto builds_before = simulation->clock().list_builds;
    for (int i = 0; i < repetitions; ++i) per_step.push_back(run_for(seconds));
    std::nth_element(per_step.begin(), per_step.begin() + repetitions / 2, per_step.end());
    const double median = per_step[static_cast<std::size_t>(repetitions / 2)];

    BenchmarkResult result;
    result.workload = workload;
    result.particles = simulation->particles().size();
    result.threads = thread_count();
    result.neighbours = simulation->count_neighbours();
    result.listed_neighbours = simulation->mean_listed_neighbours();
    result.skin = workload_case(workload).numerics.skin_in(D);
    const auto particles = static_cast<double>(result.particles);
    const double evaluations = particles * simulation->evaluations_per_step();
    result.evaluations_per_second = evaluations / median;
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
        workloads.push_back({.name = name,
                             .scheme = "",
                             .dimensions = 3,
                             .spacing = 0.002,
                             .length = length,
                             .width = width});
    };
    plane("channel-2d-5k", 0.2);
    plane("channel-2d-50k", 2.0);
    plane("channel-2d-1m", 40.0);
    space("channel-3d-200k", 0.16, 0.18);
    space("channel-3d-1m", 0.4, 0.36);
    space("channel-3d-8m", 1.16, 0.98);
    std::vector<Workload> all;
    for (const char* scheme : {"plain", "default", "spheres", "resolved"}) {
        for (Workload w : workloads) {
            w.scheme = scheme;
            if (w.dimensions == 3 || !w.is_spatial()) all.push_back(w);
        }
    }
    return all;
}

std::size_t workload_particles(const Workload& workload) {
    return lattice_of(workload_case(workload)).places();
}

double workload_memory(const Workload& workload) {
    // Peaks of the resident memory measured with 1M particles, rounded up, and the program itself.
    const double per_particle = workload.dimensions == 2 ? 300.0 : 400.0;
    return 50e6 + per_particle * static_cast<double>(workload_particles(workload));
}

double BenchmarkResult::useful_rate() const {
    return 1e-9 * pairs_per_second() *
           pair_operations(workload.dimensions, workload.scheme != "plain", workload.scheme == "spheres")
               .sum();
}

BenchmarkResult run_benchmark(const Workload& workload, int threads, int repetitions, double seconds) {
    set_thread_count(threads);
    return workload.dimensions == 2 ? run_in<2>(workload, repetitions, seconds)
                                    : run_in<3>(workload, repetitions, seconds);
}

}  // namespace riffle::inline solver
