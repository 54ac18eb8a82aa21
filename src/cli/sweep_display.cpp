#include "cli/sweep_display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "cli/terminal.hpp"

namespace riffle {

namespace {

std::string progress_text(const SweepProgress& p) {
    std::string text = fmt::format("{} of {} runs done", p.complete, p.runs);
    if (p.failed > 0) {
        text += fmt::format(", {} failed", p.failed);
    }
    text += fmt::format(" | {} running", p.running.size());
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < std::min(most, p.running.size()); ++i) {
        text +=
            fmt::format("{} {} {:.0f} %", i == 0 ? ":" : ",", p.running[i].name, 100.0 * p.running[i].share);
    }
    if (p.running.size() > most) {
        text += " ...";
    }
    return text +
           (std::isfinite(p.seconds_left) ? fmt::format(" | {} left", duration_text(p.seconds_left)) : "");
}

/// The first line of a message; the rest is in the log of the run.
std::string first_line(const std::string& message) { return message.substr(0, message.find('\n')); }

}  // namespace

SweepDisplay::SweepDisplay(bool quiet) : quiet_(quiet), terminal_(error_stream_is_terminal()) {}

void SweepDisplay::show(const SweepProgress& progress) {
    if (quiet_) {
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    const auto pause = terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10'000);
    if (now - last_line_ < pause) {
        return;
    }
    last_line_ = now;
    if (terminal_) {
        fmt::print(stderr, "\r\x1b[K{}", progress_text(progress));
        std::fflush(stderr);
        open_line_ = true;
    } else {
        fmt::print(stderr, "{}\n", progress_text(progress));
    }
}

void SweepDisplay::show_end(const SweepRun& run, const RunReport& report, bool resumed) {
    clear();
    if (report.fate == RunFate::failed) {
        print_error(fmt::format("{}: {}", run.combination.name, report.message));
    } else if (!quiet_) {
        fmt::print("{}: {}{}\n", run.combination.name, resumed ? "resumed, " : "",
                   first_line(report.message));
        std::fflush(stdout);
    }
}

void SweepDisplay::clear() {
    if (open_line_) {
        fmt::print(stderr, "\r\x1b[K");
        std::fflush(stderr);
        open_line_ = false;
    }
}

void print_matrix(const std::vector<SweepRun>& runs, const std::vector<FolderStanding>& standings,
                  const std::vector<std::optional<Forecast>>& forecasts, const Shares& shares) {
    std::size_t width = 3;
    for (const SweepRun& run : runs) {
        width = std::max(width, run.combination.name.size());
    }
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
                       first_line(standings[i].reason));
        }
    }
}

}  // namespace riffle
