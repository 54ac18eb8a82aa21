#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "particles/lost_particle.hpp"
#include "solver/summary.hpp"

namespace riffle::inline solver {

/// Files of a run in its folder.
struct RunFiles {
    std::filesystem::path folder;
    [[nodiscard]] std::filesystem::path results() const { return folder / "results.h5"; }
    [[nodiscard]] std::filesystem::path xdmf() const { return folder / "results.xdmf"; }
    [[nodiscard]] std::filesystem::path boundary_xdmf() const { return folder / "boundaries.xdmf"; }
    [[nodiscard]] std::filesystem::path mean_field_xdmf() const { return folder / "mean_field.xdmf"; }
    [[nodiscard]] std::filesystem::path checkpoint() const { return folder / "checkpoint.h5"; }
    [[nodiscard]] std::filesystem::path log() const { return folder / "run.log"; }
    /// The moment at which the simulation failed, and its index.
    [[nodiscard]] std::filesystem::path failure() const { return folder / "failure.h5"; }
    [[nodiscard]] std::filesystem::path failure_xdmf() const { return folder / "failure.xdmf"; }
};

/// What a running simulation tells about itself.
struct RunProgress {
    double time = 0.0;      ///< simulated, s
    double end_time = 0.0;  ///< latest end, s
    /// Where the run will end, s: the latest end, or where convergence is expected from what it lacks now.
    double expected_end = 0.0;
    std::int64_t steps = 0;
    std::int64_t steps_done = 0;  ///< since the run began or was gone on with: few tell no speed
    double steps_per_second = 0.0;
    double updates_per_second = 0.0;  ///< particle force evaluations per second
    double seconds_left = 0.0;        ///< wall clock, to the expected end
    double depth_mean_velocity = 0.0;
    double drag_over_gravity = 0.0;
    double particle_order = 0.0;
    double velocity_fluctuation = 0.0;
    double density_deviation_maximum = 0.0;
    double mean_level = 0.0;
    std::string convergence;  ///< outcome of the newest convergence test, in words
    bool has_row = true;      ///< something is recorded: the numbers of the flow are known
};

/// How a run is to be carried out.
struct RunOptions {
    std::filesystem::path folder;
    bool overwrite = false;          ///< replace results that the folder holds
    int threads = 0;                 ///< 0: available_processors()
    std::vector<std::string> notes;  ///< lines for the head of the log (warnings of the case)
    std::function<void(const RunProgress&)> progress;  ///< called about every output.progress_interval
    std::function<void(const std::string&)> warn;      ///< called with what the log warns of on the way
    const std::atomic<int>* stop_signal = nullptr;     ///< non-zero: stop with a checkpoint
};

enum class RunEnd { converged, time_reached, stopped };

/// Outcome of a run.
struct RunOutcome {
    RunEnd end = RunEnd::time_reached;
    double time = 0.0;
    std::int64_t steps = 0;
    double wall_seconds = 0.0;
    double updates_per_second = 0.0;
    Numbers summary;
    std::string convergence;
    LostWater lost;        ///< water that left the domain
    std::string ways_out;  ///< how many particles on which way
};

/// Refuse what only shows when a run is set up, before anything is written: probes that the time step cannot
/// serve, a run until convergence without a steady flow to converge to. Throws InputError.
void check_runnable(const Case& c);

/// Run a case from its start. Throws FileError when the folder already holds results (unless overwrite), when
/// another process is at work in it, or it cannot be written; RunError when the simulation fails: the last
/// good checkpoint then stays, with the rows up to the failure and the moment itself (failure.h5). Earlier
/// results and checkpoints stay until the new run has begun.
RunOutcome run_case(const Case& c, const RunOptions& options);

/// Go on from a checkpoint in the folder (the newest, or `checkpoint`), bit-identical to a run without the
/// stop. `overrides` may change [run], [output] and the step of [numerics]. Everything is checked before
/// anything is changed: the files are whole and of one run, the inputs are those of its start.
RunOutcome resume_run(const RunOptions& options, const std::filesystem::path& checkpoint,
                      const std::vector<Override>& overrides);

}  // namespace riffle::inline solver
