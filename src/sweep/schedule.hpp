#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "sweep/matrix.hpp"
#include "sweep/run_folder.hpp"

namespace riffle::inline sweep {

/// What has become of a run of a sweep.
enum class RunFate {
    taken,          ///< it was complete before
    done,           ///< carried out now
    failed,         ///< failed now
    failed_before,  ///< had failed before and was left as it is
    stopped,        ///< by a signal, with a checkpoint
    waiting,        ///< not begun
};

struct RunReport {
    RunFate fate = RunFate::waiting;
    std::string message;  ///< how it ended, or its error
    int status = 0;       ///< exit status of a failed one
};

/// How far a sweep has come.
struct SweepProgress {
    std::size_t runs = 0;
    std::size_t complete = 0;  ///< those taken among them
    std::size_t failed = 0;
    std::size_t waiting = 0;
    double seconds_left = 0.0;  ///< wall clock; not-a-number until it can be told
    struct Running {
        std::string name;
        double share = 0.0;  ///< of its simulated time
    };
    std::vector<Running> running;
};

struct ScheduleOptions {
    int jobs = 0;                                   ///< runs at a time; 0: by the number of threads
    int threads = 0;                                ///< in all; 0: available_processors()
    bool force = false;                             ///< begin failed runs, and folders of other cases, anew
    const std::atomic<int>* stop_signal = nullptr;  ///< non-zero: stop all runs with checkpoints
    std::function<void(const SweepProgress&)> progress;  ///< called a few times a second
    std::function<void(const SweepRun&, const RunReport&, bool resumed)> ended;  ///< of each run carried out
};

/// Runs at a time and the threads of each.
struct Shares {
    int jobs = 1;
    int threads = 1;
};

/// Share the threads among the runs. Without a wish, four threads for each run: a small case does not keep
/// more of them busy.
[[nodiscard]] Shares shares_of(const ScheduleOptions& options, std::size_t runs);

/// Carry out the runs that are not complete, each in a process of its own: those interrupted from their
/// checkpoints, those failed before only with `force`. A run that fails does not stop the others. Must be
/// called before this process starts threads. Throws FileError where a folder holds another case, unless
/// `force`.
[[nodiscard]] std::vector<RunReport> carry_out(const std::vector<SweepRun>& runs,
                                               const std::vector<FolderStanding>& standings,
                                               const ScheduleOptions& options);

}  // namespace riffle::inline sweep
