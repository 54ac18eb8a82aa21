// What a run writes on its way, at its end, and when it fails.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "output/checkpoint_file.hpp"
#include "record/field_content.hpp"
#include "record/run_fields.hpp"
#include "solver/content.hpp"
#include "solver/failure.hpp"
#include "solver/run_content.hpp"
#include "solver/run_identity.hpp"
#include "solver/run_session.hpp"
#include "solver/state_content.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::inline solver {

namespace {

/// The setting of half the step: the fixed step rules out the Courant number.
std::string smaller_step(const Numerics& numerics) {
    return numerics.time_step ? fmt::format("numerics.time_step={:.3g}", 0.5 * *numerics.time_step)
                              : fmt::format("numerics.courant_number={:.2g}", 0.5 * numerics.courant_number);
}

}  // namespace

template <int D>
std::string RunSession<D>::leave_failure(const RunError& error) {
    std::string message = error.what();
    const auto* const fault = dynamic_cast<const ParticleFault*>(&error);
    try {
        failure_ = message;
        write_results(Moment::failed);
        write_indexes(files_, *recorder_);
        message += "\nThe results reach up to the failure.";
        if (fault != nullptr) {
            const FailureScene scene = look_around(case_, *simulation_, fault->particle());
            write_failure(files_, case_, *simulation_, scene, message);
            log_.info(neighbourhood_table(*simulation_, scene));
            message += "\n" + advice(*simulation_, scene);
            message += fmt::format(
                "\nThe moment stands in {}, the {} nearest particles in run.log; ParaView shows "
                "them with {}.",
                files_.failure().string(), scene.nearest.size(), files_.failure_xdmf().filename().string());
        }
    } catch (const FileError& unwritten) {
        message += fmt::format("\nWhat the run recorded last could not be written: {}", unwritten.what());
    }
    try {
        const double saved = CheckpointReader(files_.checkpoint()).number("/", "time");
        message += fmt::format(
            "\nThe last good checkpoint is at t = {:.6g} s ({}). To go on with a smaller step: riffle resume "
            "{} --set {}",
            saved, files_.checkpoint().string(), files_.folder.string(), smaller_step(case_.numerics));
    } catch (const FileError& unreadable) {
        message += fmt::format("\n{}", unreadable.what());
    }
    return message;
}

template <int D>
void RunSession<D>::write_out(Moment moment) {
    const auto start = Clock::now();
    write_results(moment);
    write_checkpoint();
    write_indexes(files_, *recorder_);
    last_write_ = Clock::now();
    write_seconds_ = std::chrono::duration<double>(last_write_ - start).count();
}

template <int D>
void RunSession<D>::require_own_folder() const {
    if (!lock_.holds() || lock_.in_place()) return;
    throw FileError(
        fmt::format("the folder {} was removed or moved while the run went on, and may be another run's now: "
                    "this one ends without writing there; start it again, in a folder of its own",
                    files_.folder.string()));
}

template <int D>
void RunSession<D>::write_results(Moment moment) {
    require_own_folder();
    Content content = recorder_->take_new_rows();
    content.compression = case_.output.compression;
    add_run_attributes(content, moment);
    add_profiles_content(content, twins_, *recorder_, convergence_);
    // A run that goes on has its last state in the checkpoint; the failed one is no state to start from.
    if (moment == Moment::stopped || moment == Moment::complete) {
        add_state(content, *simulation_);
    } else {
        add_clock(content, *simulation_);
    }
    // The summary whole: what it no longer says, such as an interval of too few samples, must go.
    ResultsFile::update(files_.results(), content, {}, {}, {fields::groups::summary.path});
}

template <int D>
void RunSession<D>::write_checkpoint() {
    require_own_folder();
    Content content;
    const auto number = [&](const char* name, double value) { add_attribute(content, "/", name, value); };
    number("time", simulation_->clock().time);
    number("wall_seconds", earlier_wall_seconds_ + seconds_since(begin_));
    number("next_test", next_test_);
    add_identity(content, run_id_, inputs_);
    content.datasets.push_back(case_dataset(case_));
    recorder_->save(content);
    add_state(content, *simulation_);
    CheckpointFile::write(files_.checkpoint(), content);
}

template <int D>
void RunSession<D>::add_run_attributes(Content& content, Moment moment) const {
    const auto& outcomes = fields::summary;
    const auto set = [&](const Field& field, AttributeValue value) {
        add_field(content, field, std::move(value));
    };
    set(fields::file.complete, std::int64_t{moment == Moment::complete ? 1 : 0});
    set(fields::file.failure, failure_);
    const Numbers summary = current_summary(case_, twins_, *recorder_, convergence_);
    for (const auto& [name, value] : summary.all()) {
        add_attribute(content, fields::groups::summary.path, name, value);
    }
    set(outcomes.convergence, convergence_.reason);
    set(outcomes.particles, static_cast<std::int64_t>(simulation_->particles().size()));
    set(outcomes.wall_particles, static_cast<std::int64_t>(simulation_->walls().size()));
    const LostWater water = lost();
    set(outcomes.lost_particles, static_cast<std::int64_t>(water.particles));
    set(outcomes.lost_mass, water.mass);
    set(outcomes.lost_share, water.share);
    set(outcomes.lost_ways, exits_text(simulation_->particles().lost));
    set(outcomes.steps, simulation_->clock().steps);
    set(outcomes.simulated_time, simulation_->clock().time);
    set(outcomes.sound_speed, simulation_->scheme().state.sound_speed);
    set(outcomes.crest, case_.crest());
    set(outcomes.datum, case_.datum());
    set(outcomes.total_depth, case_.total_depth());
    const double seconds = earlier_wall_seconds_ + seconds_since(begin_);
    set(outcomes.wall_clock_seconds, seconds);
    set(outcomes.threads, std::int64_t{thread_count()});
    set(outcomes.instruction_set, instruction_set_name(active_instruction_set()));
    set(outcomes.particle_updates_per_second,
        static_cast<double>(simulation_->clock().steps) * simulation_->evaluations_per_step() *
            static_cast<double>(simulation_->particles().size()) / std::max(1e-9, seconds));
}

// What run_session.cpp calls.
template std::string RunSession<2>::leave_failure(const RunError&);
template std::string RunSession<3>::leave_failure(const RunError&);
template void RunSession<2>::require_own_folder() const;
template void RunSession<3>::require_own_folder() const;
template void RunSession<2>::write_results(Moment);
template void RunSession<3>::write_results(Moment);
template void RunSession<2>::write_out(Moment);
template void RunSession<3>::write_out(Moment);
template void RunSession<2>::write_checkpoint();
template void RunSession<3>::write_checkpoint();
template void RunSession<2>::add_run_attributes(Content&, Moment) const;
template void RunSession<3>::add_run_attributes(Content&, Moment) const;

}  // namespace riffle::inline solver
