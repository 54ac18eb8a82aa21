#include "solver/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "case/words.hpp"
#include "instruments/probe_set.hpp"
#include "output/results_file.hpp"
#include "particles/lattice.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/recorder.hpp"
#include "solver/series.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"
#include "solver/state_content.hpp"
#include "sph/pair_loops.hpp"

namespace riffle {

namespace {

/// Resident memory of a run beside its particles and records: the program and its libraries (Debian 12,
/// x86-64).
constexpr double process_bytes = 24e6;

/// Bytes per particle while the particles are sorted and their lists built: order, keys, one array being
/// moved, the lists of the blocks before they are put together.
constexpr double sorting_bytes = 60.0;

/// Bytes of what a run records, before compression.
struct RecordedBytes {
    double kept = 0.0;     ///< series and profile blocks: in memory to the end and in the file
    double written = 0.0;  ///< surface and snapshots: in memory until they are written
    double state = 0.0;    ///< the last state
};

RecordedBytes recorded_bytes(const Case& c, double particles, double time) {
    const auto count = [&](double interval) { return interval > 0.0 ? time / interval : 0.0; };
    const Lattice lattice = lattice_of(c);
    const double series = count(c.output.series_interval) * 14.0 * sizeof(double);
    const double surface = c.channel.top == Top::free_surface
                               ? count(c.output.surface_interval) * (lattice.columns * 4.0 + 8.0)
                               : 0.0;
    const double blocks = time / profile_block_duration * lattice.rows * profile_quantities * sizeof(double);
    const double snapshots = (count(c.output.snapshot_interval) + 1.0) * particles * 10.0 * sizeof(float);
    return {
        .kept = series + blocks, .written = surface + snapshots, .state = particles * 9.0 * sizeof(double)};
}

/// Resident memory at the end of a run. `simulation`: bytes of its arrays.
double memory_bytes(const Case& c, const Forecast& f, const RecordedBytes& recorded, double simulation) {
    const double share = std::min(1.0, c.output.checkpoint_interval / f.wall_seconds);
    const double waiting = std::min(share * recorded.written, static_cast<double>(pending_limit));
    return process_bytes + simulation + static_cast<double>(f.particles) * sorting_bytes + recorded.state +
           recorded.kept + waiting;
}

using Clock = std::chrono::steady_clock;

/// Median duration of f, s, over repetitions of some milliseconds in all: what else the machine does in
/// between does not count.
template <class F>
double typical_seconds(const F& f) {
    constexpr double enough = 4e-3;
    constexpr std::size_t least = 5;
    constexpr std::size_t most = 200;
    f();  // cold
    std::vector<double> seconds;
    double sum = 0.0;
    while (seconds.size() < least || (sum < enough && seconds.size() < most)) {
        const auto start = Clock::now();
        f();
        seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        sum += seconds.back();
    }
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle;
}

/// Cost of the instruments, measured with samples of the present state. `step_seconds`: of a step.
void forecast_probes(const Case& c, const Simulation& simulation, double step_seconds, Forecast& f) {
    const Scheme& scheme = simulation.scheme();
    const ProbeSet probes(c, largest_step(c, scheme));
    f.probe_notes = probes.notes();
    const auto make_view = [&] {
        return FluidView(simulation.particles(), domain_of(c), c.numerics.kernel, scheme.density,
                         scheme.smoothing_length, c.output.surface_detection);
    };
    const FluidView view = make_view();
    const FlowState state = flow_state(simulation, &view);
    // Instruments that are due together share one view: its cost is that of the fastest, by frequency.
    double fastest = 0.0;
    double sum = 0.0;
    for (const auto& member : probes.members()) {
        if (member.instrument->looks_at_fluid()) {
            fastest = std::max(fastest, member.instrument->probe().sampling_frequency);
            sum += member.instrument->probe().sampling_frequency;
        }
    }
    const double view_seconds = sum > 0.0 ? typical_seconds([&] { (void)make_view(); }) * fastest / sum : 0.0;
    for (const auto& member : probes.members()) {
        Instrument& instrument = *member.instrument;
        const Probe& probe = instrument.probe();
        ProbeForecast p{.name = probe.name,
                        .kind = std::string(word(probe.kind)),
                        .standard = member.standard,
                        .sampling_frequency = probe.sampling_frequency,
                        .points = instrument.points()};
        const double seconds = typical_seconds([&] {
                                   instrument.sample(state);
                                   (void)instrument.take();
                               }) +
                               (instrument.looks_at_fluid() ? view_seconds : 0.0);
        p.samples = std::max(0.0, std::floor((f.end_time - probe.start) * probe.sampling_frequency + 1e-9));
        p.bytes = recorded_rows(instrument, f.end_time) * static_cast<double>(instrument.row_bytes());
        p.time_share = seconds * p.samples / (step_seconds * f.steps);
        f.probes.push_back(std::move(p));
    }
}

}  // namespace

Forecast forecast_run(const Case& c, int threads) {
    set_thread_count(threads);
    std::optional<ColumnResult> column;
    if (has_column(c)) {
        column = solve_column(c);
    }
    const ColumnResult* twin = column ? &*column : nullptr;
    const Scheme scheme = make_scheme(c, twin);
    Particles<2> particles =
        c.start.kind == StartKind::results
            ? particles_from_results(c, scheme, ResultsReader(c.start.file), c.start.file.string())
            : initial_particles(c, scheme, twin);
    const auto simulation = make_simulation(c, twin, std::move(particles));

    Forecast f;
    f.particles = simulation->particles().size();
    f.wall_particles = simulation->walls().size();
    f.spacing = scheme.spacing;
    f.smoothing_length = scheme.smoothing_length;
    f.sound_speed = scheme.state.sound_speed;
    f.maximum_velocity = scheme.maximum_velocity;
    f.latest_end = c.run.time;
    f.end_time = c.run.time;
    if (column && std::isfinite(column->relaxation_time)) {
        f.relaxation_time = column->relaxation_time;
        if (c.run.until == RunUntil::converged) {
            // The convergence test needs three relaxation times and one more of record.
            f.end_time = std::min(c.run.time, 4.0 * column->relaxation_time);
        }
    }

    // A few steps of the case itself, the first (cold) ones left out.
    for (int i = 0; i < 5; ++i) {
        simulation->step();
    }
    int steps = 0;
    const auto start = Clock::now();
    double seconds = 0.0;
    while (seconds < 0.2 && steps < 400) {
        simulation->step();
        ++steps;
        seconds = std::chrono::duration<double>(Clock::now() - start).count();
    }
    f.time_step = simulation->clock().time_step;
    f.steps = f.end_time / f.time_step;
    f.updates_per_second =
        static_cast<double>(f.particles) * simulation->evaluations_per_step() * steps / seconds;
    f.wall_seconds = f.steps * seconds / steps;
    forecast_probes(c, *simulation, seconds / steps, f);
    RecordedBytes recorded = recorded_bytes(c, static_cast<double>(f.particles), f.end_time);
    for (const ProbeForecast& probe : f.probes) {
        recorded.written += probe.bytes;
    }
    f.memory_bytes = memory_bytes(c, f, recorded, static_cast<double>(simulation->bytes()));
    // The state is in the results and in two checkpoints.
    f.disk_bytes = recorded.kept + recorded.written + 3.0 * recorded.state;
    return f;
}

}  // namespace riffle
