#include "sweep/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <system_error>
#include <thread>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/processors.hpp"
#include "solver/run.hpp"
#include "sweep/child_process.hpp"
#include "sweep/run_cost.hpp"

namespace riffle::inline sweep {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int threads_of_a_run = 4;

// What a run's process tells the sweep, a line each; the text of "end" and "error" is all that follows.
constexpr const char* progress_word = "progress";
constexpr const char* end_word = "end";
constexpr const char* error_word = "error";

/// The work of a run's process.
int run_to_end(const SweepRun& run, bool resume, int threads, const std::atomic<int>* stop,
               const ChildProcess::Tell& tell) {
    try {
        RunOptions options;
        options.folder = run.folder;
        options.threads = threads;
        options.overwrite = true;  // what may be replaced has been decided before
        options.stop_signal = stop;
        options.notes = case_warnings(run.flow);
        options.progress = [&](const RunProgress& progress) {
            tell(fmt::format("{} {:.9g}\n", progress_word, progress.time));
        };
        const RunOutcome outcome = resume ? resume_run(options, {}, {}) : run_case(run.flow, options);
        const char* const end = outcome.end == RunEnd::converged ? "converged"
                                : outcome.end == RunEnd::stopped ? "stopped"
                                                                 : "ended";
        tell(
            fmt::format("{}\n{} at t = {:.4g} s after {} steps", end_word, end, outcome.time, outcome.steps));
        return outcome.end == RunEnd::stopped ? 128 + stop->load() : 0;
    } catch (const Error& error) {
        tell(fmt::format("{}\n{}", error_word, error.what()));
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        tell(fmt::format("{}\nunexpected fault: {}", error_word, error.what()));
        return static_cast<int>(ExitCode::run_failed);
    }
}

/// A run in progress.
struct Running {
    std::size_t run = 0;
    bool resumed = false;
    ChildProcess process;
    std::string told;          ///< all that it has said
    double first_time = -1.0;  ///< simulated, when it was first heard of, s
    double time = 0.0;         ///< simulated, s

    void listen() {
        const std::string text = process.heard();
        told += text;
        // Of the progress only the newest line counts; none may be cut off.
        const std::string mark = std::string(progress_word) + " ";
        const std::size_t end = told.rfind('\n');
        const std::size_t at = end == std::string::npos ? end : told.rfind(mark, end);
        if (text.empty() || at == std::string::npos) return;
        std::istringstream(told.substr(at + mark.size())) >> time;
        if (first_time < 0.0) first_time = resumed ? time : 0.0;
    }

    /// What it said last, behind the line of this word; empty where it did not.
    [[nodiscard]] std::string behind(const std::string& word) const {
        const std::string line = word + "\n";
        const std::size_t at =
            told.starts_with(line) ? std::size_t{0} : told.find("\n" + line) + 1;  // npos + 1 is 0
        return at == 0 && !told.starts_with(line) ? "" : told.substr(at + line.size());
    }
};

class Schedule {
  public:
    Schedule(const std::vector<SweepRun>& runs, const std::vector<FolderStanding>& standings,
             const ScheduleOptions& options)
        : runs_(runs), standings_(standings), options_(options), reports_(runs.size()) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const FolderState state = standings[i].state;
            if (state == FolderState::complete) {
                reports_[i] = {RunFate::taken, "complete before", 0};
            } else if (state == FolderState::failed && !options.force) {
                reports_[i] = {RunFate::failed_before, standings[i].reason,
                               static_cast<int>(ExitCode::run_failed)};
            } else {
                waiting_.push_back(i);
            }
        }
        shares_ = shares_of(options, waiting_.size());
        for (const SweepRun& run : runs) costs_.push_back(estimate_cost(run.flow));
        if (shares_.jobs > 1) {
            // The longest first: then the last to end ends soonest.
            std::stable_sort(waiting_.begin(), waiting_.end(),
                             [&](std::size_t a, std::size_t b) { return costs_[a].work > costs_[b].work; });
        }
    }

    std::vector<RunReport> carry_out() {
        while (!waiting_.empty() || !running_.empty()) {
            const int stop = options_.stop_signal != nullptr ? options_.stop_signal->load() : 0;
            if (stop != 0) {
                pass_on(stop);
            } else {
                start_runs();
            }
            if (running_.empty()) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            look_after_runs();
            if (options_.progress) options_.progress(progress());
        }
        return reports_;
    }

  private:
    void start_runs() {
        while (!waiting_.empty() && running_.size() < static_cast<std::size_t>(shares_.jobs)) {
            const std::size_t next = waiting_.front();
            waiting_.erase(waiting_.begin());
            const SweepRun& run = runs_[next];
            const bool resume = standings_[next].state == FolderState::interrupted;
            running_.push_back({next,
                                resume,
                                ChildProcess([&](const ChildProcess::Tell& tell) {
                                    return run_to_end(run, resume, shares_.threads, options_.stop_signal,
                                                      tell);
                                }),
                                {}});
        }
    }

    void pass_on(int stop) {
        if (!passed_on_) {
            passed_on_ = true;
            for (Running& running : running_) running.process.send(stop);
        }
    }

    void look_after_runs() {
        for (auto running = running_.begin(); running != running_.end();) {
            const bool ended = running->process.ended();
            running->listen();
            if (!ended) {
                ++running;
                continue;
            }
            RunReport& report = reports_[running->run];
            report = report_of(*running);
            if (options_.ended) options_.ended(runs_[running->run], report, running->resumed);
            work_done_ += work_of(*running);
            running = running_.erase(running);
        }
    }

    [[nodiscard]] RunReport report_of(const Running& running) const {
        const int status = running.process.status();
        const std::string end = running.behind(end_word);
        if (status == 0) {
            return {RunFate::done, end, 0};
        }
        if (!end.empty()) {
            return {RunFate::stopped, end, status};
        }
        const std::string error = running.behind(error_word);
        return {RunFate::failed,
                error.empty() ? fmt::format("its process was ended by signal {}{}", status - 128,
                                            status == 137 ? " (killed; perhaps for want of memory)" : "")
                              : error,
                status};
    }

    [[nodiscard]] double share_of(const Running& running) const {
        return std::min(1.0, running.time / costs_[running.run].end_time);
    }

    /// What this sweep has worked on a run.
    [[nodiscard]] double work_of(const Running& running) const {
        const double from = std::max(0.0, running.first_time);
        return costs_[running.run].work *
               std::max(0.0, share_of(running) - from / costs_[running.run].end_time);
    }

    [[nodiscard]] SweepProgress progress() const {
        SweepProgress p;
        p.runs = runs_.size();
        p.waiting = waiting_.size();
        for (const RunReport& report : reports_) {
            p.complete += report.fate == RunFate::taken || report.fate == RunFate::done ? 1 : 0;
            p.failed += report.fate == RunFate::failed || report.fate == RunFate::failed_before ? 1 : 0;
        }
        double done = work_done_;
        double left = 0.0;
        for (const std::size_t i : waiting_) left += costs_[i].work;
        for (const Running& running : running_) {
            p.running.push_back({runs_[running.run].combination.name, share_of(running)});
            done += work_of(running);
            left += costs_[running.run].work * (1.0 - share_of(running));
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        p.seconds_left = done > 0.0 ? left * seconds / done : std::numeric_limits<double>::quiet_NaN();
        return p;
    }

    const std::vector<SweepRun>& runs_;
    const std::vector<FolderStanding>& standings_;
    const ScheduleOptions& options_;
    std::vector<RunReport> reports_;
    std::vector<std::size_t> waiting_;
    std::vector<Running> running_;
    std::vector<RunCost> costs_;
    Shares shares_;
    bool passed_on_ = false;
    double work_done_ = 0.0;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

Shares shares_of(const ScheduleOptions& options, std::size_t runs) {
    const int threads = options.threads > 0 ? options.threads : available_processors();
    const int most = std::max(1, static_cast<int>(runs));
    const int jobs =
        std::min(most, options.jobs > 0 ? options.jobs : std::max(1, threads / threads_of_a_run));
    return {jobs, std::max(1, threads / jobs)};
}

std::vector<RunReport> carry_out(const std::vector<SweepRun>& runs,
                                 const std::vector<FolderStanding>& standings,
                                 const ScheduleOptions& options) {
    if (!options.force) {
        std::string others;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (standings[i].state == FolderState::other) {
                others += fmt::format("\n{}: {}", runs[i].folder.string(), standings[i].reason);
            }
        }
        if (!others.empty()) {
            throw FileError(
                "folders of this sweep hold something else than its runs; choose another folder with -o, or "
                "replace them with --force" +
                others);
        }
    }
    return Schedule(runs, standings, options).carry_out();
}

}  // namespace riffle::inline sweep
