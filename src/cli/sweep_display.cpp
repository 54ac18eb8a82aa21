#include "cli/sweep_display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "cli/terminal.hpp"

namespace riffle::inline cli {

namespace {

std::vector<std::string> progress_parts(const SweepProgress& p) {
    std::vector<std::string> parts{fmt::format("{} of {} runs done", p.complete, p.runs)};
    if (p.failed > 0) {
        parts.front() += fmt::format(", {} failed", p.failed);
    }
    if (std::isfinite(p.seconds_left)) {
        parts.push_back(fmt::format("about {} left", duration_text(p.seconds_left)));
    }
    parts.push_back(fmt::format("{} running", p.running.size()));
    for (const auto& run : p.running) {
        parts.push_back(fmt::format("{} {:.0f} %", run.name, 100.0 * run.share));
    }
    return parts;
}

/// The first line of a message; the rest is in the log of the run.
std::string line_of_message(const std::string& message) { return message.substr(0, message.find('\n')); }

}  // namespace

SweepDisplay::SweepDisplay(bool quiet) : quiet_(quiet) {}

void SweepDisplay::show(const SweepProgress& progress) {
    // It is called far more often than anybody reads.
    constexpr auto pause = std::chrono::milliseconds(200);
    const auto now = std::chrono::steady_clock::now();
    if (!quiet_ && now - last_ >= pause) {
        last_ = now;
        line_.show(progress_parts(progress));
    }
}

void SweepDisplay::show_end(const SweepRun& run, const RunReport& report, bool resumed) {
    clear();
    if (report.fate == RunFate::failed) {
        print_error(fmt::format("{}: {}", run.combination.name, report.message));
    } else if (!quiet_) {
        fmt::print("{}: {}{}\n", run.combination.name, resumed ? "resumed, " : "",
                   line_of_message(report.message));
        std::fflush(stdout);
    }
}

void SweepDisplay::clear() { line_.clear(); }

void print_matrix(const std::vector<SweepRun>& runs, const std::vector<FolderStanding>& standings,
                  const std::vector<std::optional<Forecast>>& forecasts, const Shares& shares) {
    std::size_t width = 3;
    for (const SweepRun& run : runs) width = std::max(width, run.combination.name.size());
    fmt::print("{:<{}}  {:<12}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}\n", "run", width, "state",
               "particles", "step, ms", "until, s", "time", "memory", "disk");
    double seconds = 0.0;
    double disk = 0.0;
    std::vector<double> memory;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::string& name = runs[i].combination.name;
        if (!forecasts[i]) {
            fmt::print("{:<{}}  {}\n", name, width, word(standings[i].state));
            continue;
        }
        const Forecast& f = *forecasts[i];
        fmt::print("{:<{}}  {:<12}  {:>9}  {:>9.3g}  {:>9.3g}  {:>9}  {:>9}  {:>9}\n", name, width,
                   word(standings[i].state), f.particles, 1e3 * f.time_step, f.end_time,
                   duration_text(f.wall_seconds), size_text(f.memory_bytes), size_text(f.disk_bytes));
        seconds += f.wall_seconds;
        disk += f.disk_bytes;
        memory.push_back(f.memory_bytes);
    }
    std::sort(memory.rbegin(), memory.rend());
    memory.resize(std::min(memory.size(), static_cast<std::size_t>(shares.jobs)));
    fmt::print(
        "{} runs, {} of them to be done, {} at a time with {} thread{} each: about {} here, {} memory, at "
        "most {} disk; runs that are interrupted take the rest of their time\n",
        runs.size(), std::count_if(forecasts.begin(), forecasts.end(), [](const auto& f) { return !!f; }),
        shares.jobs, shares.threads, shares.threads == 1 ? "" : "s",
        duration_text(seconds / static_cast<double>(shares.jobs)),
        size_text(std::accumulate(memory.begin(), memory.end(), 0.0)), size_text(disk));
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (standings[i].state == FolderState::other || standings[i].state == FolderState::failed) {
            fmt::print("{}: {}: {}\n", runs[i].combination.name, word(standings[i].state),
                       line_of_message(standings[i].reason));
        }
    }
}

}  // namespace riffle::inline cli
