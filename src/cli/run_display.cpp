#include "cli/run_display.hpp"

#include <fmt/format.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "case/flow_kind.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "record/run_fields.hpp"

namespace riffle::inline cli {

namespace {

std::atomic<int> stop_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "set from a signal handler");

extern "C" void riffle_note_signal(int number) { stop_signal.store(number); }

/// The most important first: a narrow terminal shows no more than fits.
std::vector<std::string> progress_parts(const RunProgress& p) {
    const bool certain = p.expected_end == p.end_time;
    const std::string steps = fmt::format("{:.0f} steps/s", p.steps_per_second);
    const std::string updates = fmt::format("{:.2f} M updates/s", p.updates_per_second * 1e-6);
    if (!p.has_row) {
        return {fmt::format("t = {:.2g} of {}{:.4g} s", p.time, certain ? "" : "about ", p.expected_end),
                "nothing recorded yet", steps, updates};
    }
    constexpr std::int64_t telling = 10;  // the first steps build lists and fetch memory
    const bool known = p.steps_done >= telling;
    return {fmt::format("t = {:.2f} of {}{:.4g} s", p.time, certain ? "" : "about ", p.expected_end),
            known ? fmt::format("{}{} left", certain ? "" : "about ", duration_text(p.seconds_left))
                  : std::string("time left not known yet"),
            fmt::format("U {:.4f} m/s", p.depth_mean_velocity),
            fmt::format("drag/gravity {:.3f}", p.drag_over_gravity),
            fmt::format("level {:.2f} mm", 1e3 * p.mean_level),
            fmt::format("u' {:.1f} mm/s", 1e3 * p.velocity_fluctuation),
            fmt::format("order {:.2f}", p.particle_order),
            steps,
            updates};
}

void print_value(const char* label, double value, double half_width, std::optional<double> measured) {
    if (!std::isfinite(value)) return;
    std::string line = fmt::format("  {:<34} {:>9.4g}", label, value);
    if (std::isfinite(half_width)) {
        line += fmt::format(" +- {:.2g}", half_width);
    }
    if (measured) {
        line += fmt::format("   measured {:.4g} ({:+.1f} %)", *measured, 100.0 * (value / *measured - 1.0));
    }
    fmt::print("{}\n", line);
}

}  // namespace

RunDisplay::RunDisplay(bool quiet) : quiet_(quiet) {}

void RunDisplay::show(const RunProgress& progress) {
    if (quiet_) return;
    try {
        line_.show(progress_parts(progress));
    } catch (const std::system_error&) {
        quiet_ = true;  // nobody listens any more, which must not end the run
    }
}

void RunDisplay::warn(const std::string& warning) {
    if (quiet_) return;
    try {
        line_.clear();
        print_warning(warning);
    } catch (const std::system_error&) {
        quiet_ = true;
    }
}

void RunDisplay::finish() { line_.finish(); }

const std::atomic<int>& catch_stop_signals() {
    // The default action comes back after the first signal: a second Ctrl-C ends the program at once.
    struct sigaction stop {};
    stop.sa_handler = riffle_note_signal;
    stop.sa_flags = static_cast<int>(SA_RESETHAND);
    // SIGXCPU, SIGUSR1 and SIGUSR2 are how batch systems tell that the time is nearly over.
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2}) {
        struct sigaction before {};
        sigaction(number, nullptr, &before);
        if (before.sa_handler != SIG_IGN) {  // as nohup asks for
            sigaction(number, &stop, nullptr);
        }
    }
    // A file that may not grow further, and a terminal that is gone, are told by the failing write.
    (void)std::signal(SIGXFSZ, SIG_IGN);
    (void)std::signal(SIGPIPE, SIG_IGN);
    return stop_signal;
}

void print_outcome(const RunOutcome& outcome, const Case& c, const RunFiles& files, bool quiet) {
    if (outcome.end == RunEnd::stopped) verb_exit_status() = 128 + stop_signal.load();
    if (quiet) return;
    const char* end = outcome.end == RunEnd::converged
                          ? "converged"
                          : (outcome.end == RunEnd::stopped ? "stopped" : "ended");
    fmt::print("{} at t = {:.4g} s after {} steps, {} ({:.2f} M particle updates/s)\n{}\n", end, outcome.time,
               outcome.steps, duration_text(outcome.wall_seconds), outcome.updates_per_second * 1e-6,
               outcome.convergence);
    if (outcome.lost.particles > 0) {
        fmt::print("{} left: {}\n", lost_text(outcome.lost), outcome.ways_out);
    }
    const Numbers& s = outcome.summary;
    const double none = std::nan("");
    // The laboratory measures on the centreline; a channel that repeats itself across has none.
    const bool between_walls = c.has_side_walls();
    print_value("depth-mean velocity, m/s", s.value(fields::summary.depth_mean_velocity),
                s.value(fields::summary.depth_mean_velocity_half_width),
                between_walls ? std::nullopt : c.measured.depth_mean_velocity);
    if (between_walls) {
        print_value("on the centreline, m/s", s.value(fields::summary.centreline_velocity),
                    s.value(fields::summary.centreline_velocity_half_width), c.measured.depth_mean_velocity);
    }
    if (c.channel.dimensions == 3) {
        print_value("secondary velocity, mm/s", 1e3 * s.value(fields::summary.secondary_velocity), none,
                    std::nullopt);
    }
    // The weight is what drives the water, and the stress a line over the depth, in uniform flow alone.
    const bool uniform = flow_kind(c) == FlowKind::uniform_channel;
    if (uniform) {
        print_value("friction velocity (stress), m/s", s.value(fields::summary.friction_velocity), none,
                    c.measured.friction_velocity);
    }
    print_value("friction velocity (log law), m/s", s.value(fields::summary.log_law_friction_velocity),
                s.value(fields::summary.log_law_friction_velocity_half_width), c.measured.friction_velocity);
    print_value("equivalent roughness k_s, mm", 1e3 * s.value(fields::summary.equivalent_roughness),
                1e3 * s.value(fields::summary.equivalent_roughness_half_width),
                c.measured.equivalent_roughness ? std::optional(1e3 * *c.measured.equivalent_roughness)
                                                : std::nullopt);
    if (is_channel(flow_kind(c)) && c.channel.slope > 0.0) {
        print_value("drag over gravity", s.value(fields::summary.drag_over_gravity), none, std::nullopt);
    }
    if (!c.vegetation.empty()) {
        print_value("vegetation over gravity", s.value(fields::summary.vegetation_over_gravity), none,
                    std::nullopt);
    }
    if (!c.porous.empty()) {
        print_value("porous zones over gravity", s.value(fields::summary.porous_over_gravity), none,
                    std::nullopt);
    }
    if (c.has_side_walls()) {
        print_value("side walls' drag over gravity", s.value(fields::summary.side_wall_over_gravity), none,
                    std::nullopt);
    }
    if (uniform) {
        print_value("spurious pressure stress, %", 100.0 * s.value(fields::summary.spurious_stress_rms), none,
                    std::nullopt);
    }
    fmt::print("results: {}\n", files.results().string());
    if (outcome.end == RunEnd::stopped) {
        fmt::print("go on with: riffle resume {}\n", files.folder.string());
    } else {
        fmt::print("report:  riffle report {}\n", files.folder.string());
    }
}

}  // namespace riffle::inline cli
