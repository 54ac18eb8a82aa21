#include "solver/run_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/version.hpp"
#include "output/checkpoint_file.hpp"
#include "particles/lattice.hpp"
#include "solver/content.hpp"
#include "solver/run_content.hpp"
#include "solver/start.hpp"
#include "solver/state_content.hpp"
#include "sph/pair_loops.hpp"

namespace riffle {

namespace {

constexpr const char* no_steady_flow = "no steady flow to converge to";

/// Share of the time that writing may take before it is done less often.
constexpr double write_share = 0.02;

/// Simulated time between two convergence tests, s.
constexpr double test_interval = 1.0;

/// The setting of half the step: the fixed step rules out the Courant number.
std::string smaller_step(const Numerics& numerics) {
    return numerics.time_step ? fmt::format("numerics.time_step={:.3g}", 0.5 * *numerics.time_step)
                              : fmt::format("numerics.courant_number={:.2g}", 0.5 * numerics.courant_number);
}

}  // namespace

template <int D>
RunSession<D>::RunSession(Case c, RunOptions options)
    : case_(std::move(c)), options_(std::move(options)), files_{options_.folder}, log_(files_.log()) {
    set_thread_count(options_.threads);
    twins_ = solve_twins(case_);
    convergence_.reason = twins_.column ? "not yet tested for convergence" : no_steady_flow;
}

template <int D>
void RunSession<D>::make_simulation_of_case(bool from_start) {
    const ColumnResult* column = twins_.column_or_null();
    const Scheme scheme = make_scheme(case_, column);
    Particles<D> particles;
    if (from_start && case_.start.kind == StartKind::results) {
        particles = particles_from_results<D>(case_, scheme, ResultsReader(case_.start.file),
                                              case_.start.file.string());
    } else {
        particles = initial_particles<D>(case_, scheme, column, twins_.section_velocity());
    }
    simulation_ = make_simulation<D>(case_, column, std::move(particles));
    recorder_ = std::make_unique<Recorder>(case_, twins_);
}

template <int D>
void RunSession<D>::start() {
    make_simulation_of_case(true);
    const Scheme& scheme = simulation_->scheme();
    log_.info(fmt::format("riffle {} ({}), {} instructions, {}", version(), build_description(),
                          instruction_set_name(active_instruction_set()), thread_description()));
    log_.info(fmt::format("case: {}", case_.title));
    for (const std::string& note : options_.notes) {
        log_.warning(note);
    }
    log_.info(fmt::format(
        "{} fluid and {} wall particles, spacing {:.4g} mm, h {:.4g} mm, c0 {:.4g} m/s, step <= {:.4g} s",
        simulation_->particles().size(), simulation_->walls().size(), 1e3 * scheme.spacing,
        1e3 * scheme.smoothing_length, scheme.state.sound_speed, scheme.acoustic_step));
    if (!case_.solids.empty() && case_.start.water_x.empty()) {
        log_.info(fmt::format("{} particles of the water's lattice are left out, in or too close to solids",
                              lattice_of(case_).places(D) - simulation_->particles().size()));
    }
    Content content = run_head(case_, twins_);
    content.compression = case_.output.compression;
    recorder_->record(*simulation_);
    add_run_attributes(content, false);
    ResultsFile::create(files_.results(), content, options_.overwrite);
    write_out(false);
}

template <int D>
void RunSession<D>::resume(const std::filesystem::path& checkpoint) {
    const Content saved = CheckpointFile::read(checkpoint);
    // The start particles only give the arrays their walls and sizes; the state replaces them. A start from a
    // results file that is gone must not stop a resume.
    if (case_.start.kind == StartKind::results) {
        Case still = case_;
        still.start.kind = StartKind::rest;
        const Case keep = case_;
        case_ = still;
        make_simulation_of_case(false);
        case_ = keep;
    } else {
        make_simulation_of_case(false);
    }
    restore_state(saved, "/state", *simulation_);
    recorder_->restore(saved, ResultsReader(files_.results()));
    earlier_wall_seconds_ = checkpoint_number(saved, "wall_seconds");
    next_test_ = checkpoint_number(saved, "next_test");
    first_step_ = simulation_->clock().steps;
    // The results may be ahead of the checkpoint: cut them back before anything is added.
    Content content;
    content.datasets.push_back(case_dataset(case_));
    ResultsFile::update(files_.results(), content, recorder_->rows(),
                        recorder_->snapshots().entries().size());
    log_.info(fmt::format("resumed at t = {:.6g} s, step {}, from {}", simulation_->clock().time,
                          simulation_->clock().steps, checkpoint.filename().string()));
    update_convergence(false);
}

template <int D>
double RunSession<D>::seconds_since(Clock::time_point t) const {
    return std::chrono::duration<double>(Clock::now() - t).count();
}

template <int D>
bool RunSession<D>::finished() const {
    // A hair's breadth of the step's rounding must not cost another step.
    return simulation_->clock().time >= case_.run.time * (1.0 - 1e-12) ||
           (case_.run.until == RunUntil::converged && convergence_.converged);
}

template <int D>
RunOutcome RunSession<D>::advance() {
    bool stopped = false;
    while (!finished()) {
        if (options_.stop_signal != nullptr && options_.stop_signal->load() != 0) {
            stopped = true;
            break;
        }
        try {
            simulation_->step(recorder_->fields_due());
        } catch (const RunError& e) {
            log_.error(e.what());
            const Content saved = CheckpointFile::read(files_.checkpoint());
            throw RunError(
                fmt::format("{}\nThe last good checkpoint is at t = {:.6g} s ({}). To go on with a smaller "
                            "step: riffle resume {} --set {}",
                            e.what(), checkpoint_number(saved, "time"), files_.checkpoint().string(),
                            files_.folder.string(), smaller_step(case_.numerics)));
        }
        recorder_->record(*simulation_);
        if (simulation_->clock().time >= next_test_) {
            next_test_ = (std::floor(simulation_->clock().time / test_interval + 1e-9) + 1.0) * test_interval;
            update_convergence(false);
        }
        if (seconds_since(last_progress_) >= case_.output.progress_interval) {
            report_progress();
        }
        const double wait = std::max(case_.output.checkpoint_interval, write_seconds_ / write_share);
        if (seconds_since(last_write_) >= wait || recorder_->pending_bytes() > pending_limit) {
            write_out(false);
        }
    }
    if (!stopped) {
        update_convergence(true);
    }
    report_progress();
    write_out(!stopped);

    RunOutcome outcome;
    outcome.end =
        stopped ? RunEnd::stopped
                : (case_.run.until == RunUntil::converged && convergence_.converged ? RunEnd::converged
                                                                                    : RunEnd::time_reached);
    outcome.time = simulation_->clock().time;
    outcome.steps = simulation_->clock().steps;
    outcome.wall_seconds = earlier_wall_seconds_ + seconds_since(begin_);
    const double evaluations =
        static_cast<double>(outcome.steps - first_step_) * simulation_->evaluations_per_step();
    outcome.updates_per_second = evaluations * static_cast<double>(simulation_->particles().size()) /
                                 std::max(1e-9, seconds_since(begin_));
    outcome.summary = current_summary(case_, twins_, *recorder_, convergence_);
    outcome.convergence = convergence_.reason;
    log_.info(fmt::format("{} at t = {:.6g} s after {} steps: {}", stopped ? "stopped" : "finished",
                          outcome.time, outcome.steps, convergence_.reason));
    return outcome;
}

template <int D>
void RunSession<D>::update_convergence(bool final_test) {
    const TimeSeries& series = recorder_->series();
    if (!twins_.column) {
        // No steady flow to converge to: averages over the second half, or from the asked time.
        convergence_.window_start = case_.run.average_from.value_or(0.5 * simulation_->clock().time);
        convergence_.reason = no_steady_flow;
        return;
    }
    convergence_ = test_convergence({.time = series.column("time"),
                                     .depth_mean_velocity = series.column("depth_mean_velocity"),
                                     .velocity_fluctuation = series.column("velocity_fluctuation")},
                                    twins_.relaxation_time().value_or(0.0), case_.run.tolerance,
                                    case_.run.average_from.value_or(-1.0));
    if (final_test && !convergence_.converged && !case_.run.average_from) {
        // A run cut short still averages something: its second half, marked as not converged.
        convergence_.window_start = std::min(convergence_.window_start, 0.5 * simulation_->clock().time);
    }
}

template <int D>
void RunSession<D>::write_out(bool complete) {
    const auto start = Clock::now();
    {
        // Gone before the checkpoint is made: both hold copies of the state.
        Content content = recorder_->take_new_rows();
        content.compression = case_.output.compression;
        add_run_attributes(content, complete);
        add_profiles_content(content, twins_, *recorder_, convergence_);
        add_state(content, "/state", *simulation_);
        ResultsFile::update(files_.results(), content);
    }
    write_checkpoint();
    write_indexes(files_, *recorder_);
    last_write_ = Clock::now();
    write_seconds_ = std::chrono::duration<double>(last_write_ - start).count();
}

template <int D>
void RunSession<D>::write_checkpoint() {
    Content content;
    const auto number = [&](const char* name, double value) { add_attribute(content, "/", name, value); };
    number("time", simulation_->clock().time);
    number("wall_seconds", earlier_wall_seconds_ + seconds_since(begin_));
    number("next_test", next_test_);
    content.datasets.push_back(case_dataset(case_));
    recorder_->save(content);
    add_state(content, "/state", *simulation_);
    CheckpointFile::write(files_.checkpoint(), content);
}

template <int D>
void RunSession<D>::add_run_attributes(Content& content, bool complete) const {
    const auto attribute = [&](const std::string& path, const std::string& name, AttributeValue value) {
        add_attribute(content, path, name, std::move(value));
    };
    attribute("/", "complete", std::int64_t{complete ? 1 : 0});
    const RunSummary summary = current_summary(case_, twins_, *recorder_, convergence_);
    for (const auto& [name, value] : summary.values) {
        attribute("/summary", name, value);
    }
    attribute("/summary", "convergence", convergence_.reason);
    attribute("/summary", "particles", static_cast<std::int64_t>(simulation_->particles().size()));
    attribute("/summary", "wall_particles", static_cast<std::int64_t>(simulation_->walls().size()));
    attribute("/summary", "steps", simulation_->clock().steps);
    attribute("/summary", "simulated_time", simulation_->clock().time);
    attribute("/summary", "sound_speed", simulation_->scheme().state.sound_speed);
    attribute("/summary", "crest", case_.crest());
    attribute("/summary", "datum", case_.datum());
    attribute("/summary", "total_depth", case_.total_depth());
    const double seconds = earlier_wall_seconds_ + seconds_since(begin_);
    attribute("/summary", "wall_clock_seconds", seconds);
    attribute("/summary", "threads", std::int64_t{thread_count()});
    attribute("/summary", "instruction_set", instruction_set_name(active_instruction_set()));
    attribute("/summary", "particle_updates_per_second",
              static_cast<double>(simulation_->clock().steps) * simulation_->evaluations_per_step() *
                  static_cast<double>(simulation_->particles().size()) / std::max(1e-9, seconds));
}

template <int D>
void RunSession<D>::report_progress() {
    last_progress_ = Clock::now();
    if (!options_.progress) {
        return;
    }
    const TimeSeries& series = recorder_->series();
    const SimulationClock& clock = simulation_->clock();
    const double seconds = std::max(1e-9, seconds_since(begin_));
    RunProgress progress;
    progress.time = clock.time;
    progress.end_time = case_.run.time;
    progress.expected_end =
        case_.run.until == RunUntil::converged && twins_.column
            ? expected_end(convergence_, clock.time, twins_.relaxation_time().value_or(0.0),
                           case_.run.tolerance, case_.run.time)
            : case_.run.time;
    progress.steps = clock.steps;
    progress.steps_per_second = static_cast<double>(clock.steps - first_step_) / seconds;
    progress.updates_per_second = progress.steps_per_second * simulation_->evaluations_per_step() *
                                  static_cast<double>(simulation_->particles().size());
    progress.seconds_left =
        progress.steps_per_second > 0.0 && clock.time_step > 0.0
            ? std::max(0.0, progress.expected_end - clock.time) / clock.time_step / progress.steps_per_second
            : 0.0;
    progress.depth_mean_velocity = series.last("depth_mean_velocity");
    progress.drag_over_gravity = series.last("drag_over_gravity");
    progress.particle_order = series.last("particle_order");
    progress.velocity_fluctuation = series.last("velocity_fluctuation");
    progress.density_deviation_maximum = series.last("density_deviation_maximum");
    progress.mean_level = recorder_->mean_level();
    progress.convergence = convergence_.reason;
    options_.progress(progress);
}

template class RunSession<2>;
template class RunSession<3>;

}  // namespace riffle
