#include "solver/run_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <initializer_list>
#include <map>
#include <numeric>
#include <system_error>
#include <utility>

#include "base/due_times.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/version.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/quiet_water.hpp"
#include "output/checkpoint_file.hpp"
#include "particles/lattice.hpp"
#include "record/field_content.hpp"
#include "record/flow_fields.hpp"
#include "record/particle_fields.hpp"
#include "record/run_fields.hpp"
#include "solver/run_content.hpp"
#include "solver/run_identity.hpp"
#include "solver/start.hpp"
#include "solver/state_content.hpp"
#include "solver/write_rule.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::inline solver {

namespace {

/// Why a run is not tested for convergence.
const char* reason_without_test(const Case& c) {
    return is_undriven(flow_kind(c)) || changes_at_ends(c)
               ? "no steady flow to converge to"
               : "not tested for convergence: the run ends at a given time";
}

/// Share of the time that writing may take before it is done less often.
constexpr double write_share = 0.02;

/// Simulated time between two convergence tests, s.
constexpr double test_interval = 1.0;

/// Remove files where they are there; that they stay hurts nobody.
void remove_files(std::initializer_list<std::filesystem::path> files) {
    for (const std::filesystem::path& file : files) {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    }
}

/// Throw FileError unless the results have so many rows and snapshots.
void require_rows(const ResultsReader& results, const std::map<std::string, std::size_t>& rows,
                  std::size_t snapshots) {
    const auto require = [&](const std::string& path, bool there) {
        if (!there) {
            throw FileError(fmt::format(
                "{}: ends before the checkpoint: {} lacks rows of it. The results are older than the "
                "checkpoint, or of another run; put back those that belong to it",
                results.path().string(), path));
        }
    };
    for (const auto& [path, count] : rows) {
        const std::vector<std::size_t> shape =
            results.has(path) ? results.shape(path) : std::vector<std::size_t>();
        require(path, count == 0 || (!shape.empty() && shape[0] >= count));
    }
    for (std::size_t i = 0; i < snapshots; ++i) require(snapshot_group(i), results.has(snapshot_group(i)));
}

}  // namespace

template <int D>
RunSession<D>::RunSession(Case c, RunOptions options, const FolderLock& lock)
    : case_(std::move(c)),
      options_(std::move(options)),
      lock_(lock),
      files_{options_.folder},
      log_(files_.log()) {
    set_thread_count(options_.threads);
    twins_ = solve_twins(case_);
    relaxation_time_ = tested_relaxation_time(case_, twins_).value_or(0.0);
    convergence_.reason = is_tested() ? "not yet tested for convergence" : reason_without_test(case_);
    if (case_.channel.ends == Ends::open && !is_duct(case_)) {
        end_events_.emplace(waves_of(case_, true), waves_of(case_, false), lattice_of(case_).dz,
                            case_.outflow.kind == OutflowKind::depth);
    }
}

template <int D>
void RunSession<D>::make_simulation_of_case(bool from_start) {
    const ColumnResult* column = twins_.column_or_null();
    const Scheme scheme = make_scheme(case_, column);
    if (from_start && case_.start.kind == StartKind::results) {
        simulation_ = simulation_from_results<D>(case_, column, scheme);
    } else {
        // A checkpoint takes the place of these: they need neither be read nor packed.
        Case start = case_;
        if (!from_start && start.start.kind == StartKind::results) start.start.kind = StartKind::rest;
        simulation_ = make_simulation<D>(
            case_, column,
            initial_particles<D>(start, scheme, column, twins_.section_velocity(), from_start));
    }
    recorder_ = std::make_unique<Recorder>(case_, twins_);
}

template <int D>
template <class F>
RunOutcome RunSession<D>::logged(const F& f) {
    try {
        f();
        return advance();
    } catch (const Error& error) {
        log_.error(error.what());
        throw;
    } catch (const std::exception& error) {
        log_.error(std::string("unexpected fault: ") + error.what());
        throw;
    }
}

template <int D>
RunOutcome RunSession<D>::run() {
    return logged([&] { start(); });
}

template <int D>
RunOutcome RunSession<D>::resume(const std::filesystem::path& checkpoint,
                                 const std::vector<std::string>& warnings) {
    return logged([&] { restore(checkpoint, warnings); });
}

template <int D>
void RunSession<D>::start() {
    run_id_ = new_run_id();
    inputs_ = input_checksums(case_);
    make_simulation_of_case(true);
    const Scheme& scheme = simulation_->scheme();
    log_.info(fmt::format("riffle {} ({}), {} instructions, {}", version(), build_description(),
                          instruction_set_name(active_instruction_set()), thread_description()));
    log_.info(fmt::format("case: {}", case_.title));
    for (const std::string& note : options_.notes) log_.warning(note);
    log_.info(fmt::format(
        "{} fluid and {} wall particles, spacing {:.4g} mm, h {:.4g} mm, c0 {:.4g} m/s, step <= {:.4g} s",
        simulation_->particles().size(), simulation_->walls().size(), 1e3 * case_.numerics.spacing,
        1e3 * scheme.smoothing_length, scheme.state.sound_speed, scheme.acoustic_step));
    if (const auto note = quiet_water_note(case_)) {
        log_.info(fmt::format("still water: {}", *note));
    }
    // Between open ends there is water beyond the lattice of the channel as well.
    if (!case_.solids.empty() && case_.start.water_x.empty() && case_.channel.ends != Ends::open) {
        log_.info(fmt::format("{} particles of the water's lattice are left out, in or too close to solids",
                              lattice_of(case_).places() - simulation_->particles().size()));
    }
    Content content = run_head(case_, twins_);
    content.compression = case_.output.compression;
    recorder_->snapshots().boundaries().add(content);
    recorder_->record(*simulation_);
    add_identity(content, run_id_, inputs_);
    add_run_attributes(content, Moment::on_the_way);
    ResultsFile::create(files_.results(), content, options_.overwrite);
    // What an earlier run has left here has been replaced up to this, and is of no more use.
    remove_files({files_.xdmf(), files_.mean_field_xdmf(), files_.failure(), files_.failure_xdmf()});
    write_out(Moment::on_the_way);
    remove_files({CheckpointFile::previous(files_.checkpoint())});
}

template <int D>
void RunSession<D>::restore(const std::filesystem::path& checkpoint,
                            const std::vector<std::string>& warnings) {
    {
        const CheckpointReader saved(checkpoint);
        const ResultsReader results(files_.results());
        results.verify();
        require_same_run(saved, results);
        run_id_ = run_id_of(saved);
        inputs_ = saved.read_string(fields::stored_case.inputs.path());
        for (const std::string& warning : warnings) tell(warning);
        // The start particles only give the arrays their walls and sizes; the state replaces them. A start
        // from a results file that is gone must not stop a resume.
        make_simulation_of_case(false);
        restore_state(saved, *simulation_);
        if (end_events_) end_events_->go_on(simulation_->clock().open_ends);
        tell_of_past_end();
        recorder_->restore(saved, results);
        require_rows(results, recorder_->rows(), recorder_->snapshots().entries().size());
        earlier_wall_seconds_ = saved.number("/", "wall_seconds");
        next_test_ = saved.number("/", "next_test");
        first_step_ = simulation_->clock().steps;
        told_losses_ = simulation_->particles().lost.size();
        update_convergence(false);
        if (finished()) recorder_->keep_end(results, simulation_->clock().time);
    }
    // From here on the folder is changed. Another checkpoint than the newest becomes it first: with that one
    // the results that are cut back could not be gone on with.
    CheckpointFile::adopt(files_.checkpoint(), checkpoint);
    // The results may be ahead of the checkpoint: cut them back before anything is added.
    Content content;
    content.datasets.push_back(case_dataset(case_));
    add_field(content, fields::file.complete, std::int64_t{0});
    add_field(content, fields::file.failure, std::string());
    add_identity(content, run_id_, inputs_);
    add_clock(content, *simulation_);
    ResultsFile::update(files_.results(), content, recorder_->rows(), recorder_->snapshots().entries().size(),
                        {fields::groups::state.path});
    remove_files({files_.failure(), files_.failure_xdmf()});
    log_.info(fmt::format("resumed at t = {:.6g} s, step {}, from {}", simulation_->clock().time,
                          simulation_->clock().steps, checkpoint.filename().string()));
}

template <int D>
void RunSession<D>::tell_of_past_end() {
    const double reached = simulation_->clock().time;
    if (reached - simulation_->clock().time_step <= case_.run.time) return;
    tell(fmt::format("the run has reached t = {:.6g} s, and run.until is {:.6g} s: it ends where it is",
                     reached, case_.run.time));
}

template <int D>
double RunSession<D>::seconds_since(Clock::time_point t) const {
    return std::chrono::duration<double>(Clock::now() - t).count();
}

template <int D>
bool RunSession<D>::is_tested() const {
    return twins_.column.has_value() || converges_between_ends(case_);
}

template <int D>
bool RunSession<D>::finished() const {
    // A hair's breadth of the step's rounding must not cost another step.
    return simulation_->clock().time >= case_.run.time * (1.0 - 1e-12) ||
           (case_.run.until == RunUntil::converged && convergence_.converged);
}

template <int D>
double RunSession<D>::fields_due() const {
    // The end comes with the time of the case, or with a test of convergence.
    return std::min(
        {recorder_->fields_due(), earliest_of(next_test_, test_interval), case_.run.time * (1.0 - 1e-12)});
}

template <int D>
RunOutcome RunSession<D>::advance() {
    bool stopped = false;
    while (!finished() && !stopped) {
        // Asked to stop, it makes one more step, whose fields are those of the last snapshot.
        stopped = options_.stop_signal != nullptr && options_.stop_signal->load() != 0;
        step(stopped ? 0.0 : fields_due());
        recorder_->record(*simulation_);
        report_losses();
        report_end_events();
        if (has_come(simulation_->clock().time, next_test_, test_interval)) {
            next_test_ = due_next(simulation_->clock().time, next_test_, test_interval);
            update_convergence(false);
        }
        if (seconds_since(last_progress_) >= case_.output.progress_interval) report_progress();
        if (stopped) break;
        const double wait = std::max(wait_for_write(seconds_since(begin_), case_.output.checkpoint_interval),
                                     write_seconds_ / write_share);
        if (seconds_since(last_write_) >= wait) {
            write_out(Moment::on_the_way);
        } else if (recorder_->should_be_written()) {
            write_results(Moment::on_the_way);
        }
    }
    stopped = stopped && !finished();
    if (!stopped) update_convergence(true);
    if (simulation_->clock().steps > first_step_) recorder_->record_end(*simulation_);
    report_progress();
    write_out(stopped ? Moment::stopped : Moment::complete);

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
    outcome.lost = lost();
    outcome.ways_out = exits_text(simulation_->particles().lost);
    log_.info(fmt::format("{} at t = {:.6g} s after {} steps: {}", stopped ? "stopped" : "finished",
                          outcome.time, outcome.steps, convergence_.reason));
    return outcome;
}

template <int D>
void RunSession<D>::update_convergence(bool final_test) {
    const TimeSeries& series = recorder_->series();
    if (!is_tested()) {
        // No steady flow to converge to: averages over the second half, or from the asked time.
        convergence_.window_start = case_.run.average_from.value_or(0.5 * simulation_->clock().time);
        convergence_.reason = reason_without_test(case_);
        return;
    }
    SteadinessRecord record{.time = series.column(fields::time_series.time),
                            .depth_mean_velocity = series.column(fields::time_series.depth_mean_velocity),
                            .velocity_fluctuation = series.column(fields::time_series.velocity_fluctuation)};
    if (converges_between_ends(case_)) {
        record.ends = {.mean_level = {},
                       .outflow_discharge = series.column(fields::time_series.outflow_discharge),
                       .mass_entered = series.column(fields::time_series.mass_entered),
                       .mass_left = series.column(fields::time_series.mass_left),
                       .discharge_unit = fields::time_series.outflow_discharge.unit.in(D)};
        if (!is_duct(case_)) record.ends->mean_level = series.column(fields::time_series.mean_level);
    }
    convergence_ = test_convergence(record, relaxation_time_, case_.run.tolerance,
                                    case_.run.average_from.value_or(-1.0));
    if (final_test && !convergence_.converged && !case_.run.average_from) {
        // A run cut short still averages something: its second half, marked as not converged.
        convergence_.window_start = std::min(convergence_.window_start, 0.5 * simulation_->clock().time);
    }
}

template <int D>
void RunSession<D>::step(double fields_due) {
    try {
        simulation_->step(fields_due);
    } catch (const RunError& error) {
        throw RunError(leave_failure(error));
    }
}

template <int D>
LostWater RunSession<D>::lost() const {
    const Particles<D>& p = simulation_->particles();
    return lost_water(p.lost, std::accumulate(p.mass.begin(), p.mass.end(), 0.0));
}

template <int D>
void RunSession<D>::report_losses() {
    const std::vector<LostParticle>& ledger = simulation_->particles().lost;
    // The first ones each, then once for every doubling: a tank that overflows must not fill the log.
    constexpr std::size_t told_each = 10;
    if (ledger.size() <= told_losses_ || (told_losses_ >= told_each && ledger.size() < 2 * told_losses_)) {
        return;
    }
    for (std::size_t i = told_losses_; i < std::min(ledger.size(), told_each); ++i) {
        const LostParticle& p = ledger[i];
        log_.warning(fmt::format(
            "particle {} left {} and was taken out at t = {:.6g} s: x = {:.4g} m, z = "
            "{:.4g} m, velocity ({:.3g}, {:.3g}) m/s",
            p.id, exit_text(p.exit), p.time, p.position[0], p.position[2], p.velocity[0], p.velocity[2]));
    }
    told_losses_ = ledger.size();
    const LostWater water = lost();
    tell(fmt::format("so far {}: {}", lost_text(water), exits_text(ledger)));
}

template <int D>
void RunSession<D>::tell(const std::string& warning) {
    log_.warning(warning);
    if (options_.warn) options_.warn(warning);
}

template <int D>
void RunSession<D>::report_end_events() {
    if (end_events_) {
        const SimulationClock& clock = simulation_->clock();
        for (const std::string& event : end_events_->news(clock.open_ends, clock.time)) tell(event);
        for (const std::string& event : rack_watch_.news(clock.time, clock.free_bodies)) tell(event);
    }
}

template <int D>
void RunSession<D>::report_progress() {
    last_progress_ = Clock::now();
    if (!options_.progress) return;
    const TimeSeries& series = recorder_->series();
    const SimulationClock& clock = simulation_->clock();
    const double seconds = std::max(1e-9, seconds_since(begin_));
    RunProgress progress;
    progress.time = clock.time;
    progress.end_time = case_.run.time;
    progress.expected_end =
        case_.run.until == RunUntil::converged && is_tested()
            ? expected_end(convergence_, clock.time, relaxation_time_, case_.run.tolerance, case_.run.time)
            : case_.run.time;
    progress.steps = clock.steps;
    progress.steps_done = clock.steps - first_step_;
    progress.steps_per_second = static_cast<double>(clock.steps - first_step_) / seconds;
    progress.updates_per_second = progress.steps_per_second * simulation_->evaluations_per_step() *
                                  static_cast<double>(simulation_->particles().size());
    progress.seconds_left =
        progress.steps_per_second > 0.0 && clock.time_step > 0.0
            ? std::max(0.0, progress.expected_end - clock.time) / clock.time_step / progress.steps_per_second
            : 0.0;
    progress.has_row = series.rows() > 0;
    progress.depth_mean_velocity = series.last(fields::time_series.depth_mean_velocity);
    progress.drag_over_gravity = series.last(fields::time_series.drag_over_gravity);
    if (!case_.vegetation.empty()) {
        progress.drag_over_gravity += series.last(fields::time_series.vegetation_over_gravity);
    }
    if (!case_.porous.empty()) {
        progress.drag_over_gravity += series.last(fields::time_series.porous_over_gravity);
    }
    progress.particle_order = series.last(fields::time_series.particle_order);
    progress.velocity_fluctuation = series.last(fields::time_series.velocity_fluctuation);
    progress.density_deviation_maximum = series.last(fields::time_series.density_deviation_maximum);
    progress.mean_level = recorder_->mean_level();
    progress.convergence = convergence_.reason;
    options_.progress(progress);
}

template class RunSession<2>;
template class RunSession<3>;

}  // namespace riffle::inline solver
