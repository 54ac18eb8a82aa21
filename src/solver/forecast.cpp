#include "solver/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "base/due_times.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "boundary/body_racks.hpp"
#include "case/bed_patch.hpp"
#include "case/flow_kind.hpp"
#include "case/surface_roughness.hpp"
#include "case/words.hpp"
#include "column/twin_channel.hpp"
#include "instruments/probe_set.hpp"
#include "output/file_update.hpp"
#include "output/results_file.hpp"
#include "particles/lattice.hpp"
#include "roughness/porous_resistance.hpp"
#include "roughness/vegetation.hpp"
#include "solver/averaging_rows.hpp"
#include "solver/convergence.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/recorder.hpp"
#include "solver/series.hpp"
#include "solver/simulation.hpp"
#include "solver/start.hpp"
#include "solver/state_content.hpp"
#include "solver/write_rule.hpp"
#include "sph/pair_loops.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline solver {

namespace {

/// Memory that writing takes for a while, bytes: the HDF5 library with the chunks that it compresses, and the
/// program for it.
constexpr double writing_bytes = 8e6;

/// Bytes per particle while the particles are sorted and their lists built: order, keys, one array being
/// moved, the lists of the blocks before they are put together; less what is freed before.
constexpr double sorting_bytes = 40.0;

/// Bytes of what a run records, before compression.
struct RecordedBytes {
    double kept = 0.0;     ///< series and profile blocks: in memory to the end and in the file
    double surface = 0.0;  ///< these and the instruments' records: in memory until they are written
    double surface_map = 0.0;
    double mean_field = 0.0;
    double snapshots = 0.0;
    double probes = 0.0;
    double state = 0.0;            ///< the last state
    double mean_field_sums = 0.0;  ///< of its window, in the checkpoints
    double snapshot = 0.0;         ///< one of them

    /// What waits in memory until it is written, at its end; but for the snapshot that is written at the
    /// start and the one that the rehearsal of a sample holds.
    [[nodiscard]] double waiting(double share) const {
        return std::min(share * (surface + surface_map + std::max(0.0, snapshots - 2.0 * snapshot) + probes),
                        static_cast<double>(pending_limit));
    }
};

/// Share of the lattice's particles that the snapshots' region holds.
double snapshot_share(const Case& c) {
    const auto share = [](const std::vector<double>& range, double extent) {
        return range.empty() ? 1.0
                             : std::max(0.0, std::min(range[1], extent) - std::max(range[0], 0.0)) / extent;
    };
    return share(c.output.snapshot_x, c.channel.length) * share(c.output.snapshot_z, c.total_depth()) *
           (c.channel.dimensions == 3 ? share(c.output.snapshot_y, c.channel.simulated_width()) : 1.0);
}

/// Bytes of a particle in a saved state, in which each number takes eight.
template <int D>
std::size_t state_bytes() {
    std::size_t fields = D;  // the listed positions
    Particles<D>().for_each_field([&fields](const FieldInfo&, const auto&) { ++fields; });
    return fields * sizeof(double);
}

RecordedBytes recorded_bytes(const Case& c, double particles, double time) {
    const auto count = [&](double interval) { return interval > 0.0 ? time / interval : 0.0; };
    const int dimensions = c.channel.dimensions;
    const Lattice lattice = lattice_of(c);
    RecordedBytes bytes;
    bytes.kept = count(c.output.series_interval) * static_cast<double>(TimeSeries(c).columns().size()) *
                     sizeof(double) +
                 time / profile_block_duration * averaging_rows(c) *
                     static_cast<double>(profile_quantities(dimensions)) * sizeof(double);
    if (c.channel.top == Top::free_surface) {
        bytes.surface = count(c.output.surface_interval) * (lattice.columns * 4.0 + 8.0);
    }
    if (dimensions == 3) {
        const auto places = static_cast<double>(surface_map_places(c, c.channel.length).size() *
                                                surface_map_places(c, c.channel.simulated_width()).size());
        bytes.surface_map = count(c.output.surface_map_interval) * (places * 4.0 + 8.0);
    }
    const MeanField field(c);
    bytes.mean_field =
        whole_intervals(count(c.output.mean_field_interval)) * static_cast<double>(field.row_bytes());
    bytes.mean_field_sums = static_cast<double>(field.cells() * cell_quantities * sizeof(double));
    if (c.output.snapshot_interval > 0.0) {
        bytes.snapshot =
            particles * snapshot_share(c) * static_cast<double>(SnapshotRecorder(c).bytes_per_particle());
        bytes.snapshots = (count(c.output.snapshot_interval) + 1.0) * bytes.snapshot;
    }
    bytes.state = particles * static_cast<double>(dimensions == 2 ? state_bytes<2>() : state_bytes<3>());
    return bytes;
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
template <int D>
void forecast_probes(const Case& c, const SimulationIn<D>& simulation, double step_seconds, Forecast& f) {
    const Scheme& scheme = simulation.scheme();
    const ProbeSet probes(c, largest_step(c, scheme));
    f.probe_notes = probes.notes();
    const auto make_view = [&] {
        return FluidViewIn<D>(c, simulation.particles(), scheme.smoothing_length, &simulation.walls());
    };
    const FluidViewIn<D> view = make_view();
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
        p.samples = std::max(0.0, whole_intervals((f.end_time - probe.start) * probe.sampling_frequency));
        p.bytes = recorded_rows(instrument, f.end_time) * static_cast<double>(instrument.row_bytes());
        p.time_share = seconds * p.samples / (step_seconds * f.steps);
        f.probes.push_back(std::move(p));
    }
}

/// Memory at the begin of a run, bytes, from a rehearsal: everything that is due at a sample is recorded
/// once.
template <int D>
double rehearse_memory(const Case& c, const Twins& twins, SimulationIn<D>& simulation) {
    reset_peak_memory();
    Recorder recorder(c, twins);
    simulation.step(0.0);  // the fields too
    recorder.record(simulation);
    (void)recorder.take_new_rows();
    const auto particles = static_cast<double>(simulation.particles().size());
    const double sampling = static_cast<double>(peak_memory().value_or(0));
    const double between = static_cast<double>(resident_memory().value_or(0));
    const auto free = static_cast<double>(kept_free_memory());
    return std::max({sampling, between + sorting_bytes * particles - free, between + writing_bytes});
}

BedPatchForecast forecast_of(const Case& c, const BedPatch& patch) {
    const Case everywhere = uniform_reach(with_bed_of(c, patch));
    BedPatchForecast f{patch.name, std::string(word(patch.kind)), equivalent_roughness(everywhere), 0.0};
    if (!why_no_column(everywhere)) f.velocity = solve_column(everywhere).depth_mean_velocity;
    return f;
}

template <int D>
Forecast forecast_in(const Case& c) {
    const Twins twins = solve_twins(c);
    const ColumnResult* twin = twins.column_or_null();
    const Scheme scheme = make_scheme(c, twin);
    const auto simulation =
        c.start.kind == StartKind::results
            ? simulation_from_results<D>(c, twin, scheme)
            : make_simulation<D>(c, twin,
                                 initial_particles<D>(c, scheme, twin, twins.section_velocity(), false));

    Forecast f;
    f.particles = simulation->particles().size();
    f.wall_particles = simulation->walls().size();
    f.smoothing_length = scheme.smoothing_length;
    f.sound_speed = scheme.state.sound_speed;
    f.maximum_velocity = scheme.maximum_velocity;
    f.latest_end = c.run.time;
    f.end_time = c.run.time;
    f.relaxation_time = tested_relaxation_time(c, twins);
    for (const BedPatch& patch : c.bed_patches) f.bed_patches.push_back(forecast_of(c, patch));
    for (const SurfacePatch& patch : c.surface_patches) {
        f.surface_patches.push_back({patch.name, patch.solid, surface_roughness(c, patch)});
    }
    for (const Vegetation& stems : c.vegetation) {
        const ReferenceDrag reference = reference_drag(c, stems);
        f.vegetation.push_back({stems.name, stems.frontal_area(), stems.solid_fraction(), reference.speed,
                                reference.drag_coefficient,
                                stems.height < c.total_depth() ? displacement_height(stems) : 0.0});
    }
    f.canal = canal_flow(c);
    for (const BoundaryPlane& rack : body_racks(c)) f.racks.push_back(rack.place);
    if (c.channel.ends == Ends::open) {
        f.ends = flow_at_ends(c);
        f.end_facts = end_facts(c, *f.ends);
    }
    for (const Porous& zone : c.porous) {
        const PorousResistance resistance(zone, c.fluid.kinematic_viscosity);
        // On a slope that under the weight, else that of a tenth of it.
        constexpr double gradient_without_slope = 0.1;
        const double gravity =
            c.streamwise_gravity() > 0.0 ? c.streamwise_gravity() : gradient_without_slope * c.fluid.gravity;
        const double q = resistance.discharge_at(gravity);
        const bool resists = std::isfinite(q);
        f.porous.push_back({zone.name, zone.porosity, permeability_of(zone), resistance.quadratic(),
                            resists ? q : 0.0,
                            resists && c.fluid.kinematic_viscosity > 0.0
                                ? q * grain_size_of(zone) / c.fluid.kinematic_viscosity
                                : 0.0,
                            resists ? resistance.quadratic() * q * q / resistance.of(q) : 0.0});
    }
    if (f.relaxation_time) {
        if (c.run.until == RunUntil::converged) {
            f.end_time = std::min(c.run.time, usual_relaxation_times * *f.relaxation_time);
        }
    }

    // A few steps of the case itself, the first (cold) ones left out, and without the fields of samples.
    constexpr double later = std::numeric_limits<double>::infinity();
    const double started = static_cast<double>(peak_memory().value_or(0));
    for (int i = 0; i < 5; ++i) simulation->step(later);
    int steps = 0;
    const auto start = Clock::now();
    double seconds = 0.0;
    while (seconds < 0.2 && steps < 400) {
        simulation->step(later);
        ++steps;
        seconds = std::chrono::duration<double>(Clock::now() - start).count();
    }
    f.time_step = simulation->clock().time_step;
    f.steps = f.end_time / f.time_step;
    f.updates_per_second =
        static_cast<double>(f.particles) * simulation->evaluations_per_step() * steps / seconds;
    f.wall_seconds = f.steps * seconds / steps;
    const double at_the_begin = std::max(started, rehearse_memory(c, twins, *simulation));
    simulation->step(0.0);
    forecast_probes(c, *simulation, seconds / steps, f);
    RecordedBytes recorded = recorded_bytes(c, static_cast<double>(f.particles), f.end_time);
    for (const ProbeForecast& probe : f.probes) recorded.probes += probe.bytes;
    f.memory_bytes = at_the_begin + recorded.kept +
                     recorded.waiting(std::min(
                         1.0, wait_for_write(f.wall_seconds, c.output.checkpoint_interval) / f.wall_seconds));
    f.parts = {{"series and profiles", recorded.kept},
               {"surface", recorded.surface},
               {"surface map", recorded.surface_map},
               {"mean field", recorded.mean_field},
               {"snapshots", recorded.snapshots},
               {"probes", recorded.probes},
               // The state is in the results and, with the mean field's sums, in two checkpoints.
               {"state and checkpoints", 3.0 * recorded.state + 2.0 * recorded.mean_field_sums}};
    std::erase_if(f.parts, [](const RecordForecast& part) { return part.bytes == 0.0; });
    for (const RecordForecast& part : f.parts) f.disk_bytes += part.bytes;
    const double checkpoint = recorded.state + recorded.mean_field_sums;
    const double results = std::max(0.0, f.disk_bytes - 2.0 * checkpoint);
    f.replacing_bytes = std::max(checkpoint, std::min(results, static_cast<double>(change_in_place_from)));
    return f;
}

}  // namespace

Forecast forecast_run(const Case& c, int threads) {
    set_thread_count(threads);
    return c.channel.dimensions == 2 ? forecast_in<2>(c) : forecast_in<3>(c);
}

}  // namespace riffle::inline solver
