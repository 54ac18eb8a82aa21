#include "watch/run_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

namespace riffle::inline watch {

namespace {

namespace fs = std::filesystem;

/// Age of the results below which a run is not yet called lost, s.
constexpr double shortest_patience = 10.0;

/// A line of the form "YYYY-MM-DD hh:mm:ss level message".
std::optional<LogLine> dated(std::string_view line) {
    constexpr std::string_view form = "dddd-dd-dd dd:dd:dd ";
    if (line.size() <= form.size()) return std::nullopt;
    for (std::size_t i = 0; i < form.size(); ++i) {
        const bool fits =
            form[i] == 'd' ? std::isdigit(static_cast<unsigned char>(line[i])) != 0 : line[i] == form[i];
        if (!fits) return std::nullopt;
    }
    const std::string_view rest = line.substr(form.size());
    const std::size_t gap = std::min(rest.find(' '), rest.size());
    const std::size_t start = std::min(rest.find_first_not_of(' ', gap), rest.size());
    return LogLine{std::string(line.substr(0, form.size() - 1)), std::string(rest.substr(0, gap)),
                   std::string(rest.substr(start))};
}

bool starts_with(const std::optional<LogLine>& line, std::string_view word) {
    return line && line->message.rfind(word, 0) == 0;
}

std::string name_of(const LockHolder& holder) {
    return fmt::format("Process {} {}", holder.process,
                       holder.on_this_host() ? "of this machine" : "of the machine " + holder.host);
}

std::string duration(double seconds) {
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
    return seconds < 172'800 ? fmt::format("{:.1f} h", seconds / 3600)
                             : fmt::format("{:.1f} days", seconds / 86'400);
}

/// The end of a log, without the line that the cut may have gone through; empty if it cannot be read.
std::string end_of(const fs::path& log) {
    constexpr std::streamoff most = 16'384;
    std::ifstream file(log, std::ios::binary);
    file.seekg(0, std::ios::end);
    const std::streamoff size = file.tellg();
    if (!file || size <= 0) return {};
    file.seekg(std::max<std::streamoff>(0, size - most));
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (size > most) text.erase(0, text.find('\n') + 1);
    return text;
}

}  // namespace

const char* word(RunState state) {
    switch (state) {
        case RunState::waiting:
            return "waiting";
        case RunState::running:
            return "running";
        case RunState::finished:
            return "finished";
        case RunState::stopped:
            return "stopped";
        case RunState::failed:
            return "failed";
        case RunState::unseen:
            return "unseen";
        case RunState::lost:
            break;
    }
    return "lost";
}

std::optional<LogLine> last_line(std::string_view log) {
    std::string after;
    while (!log.empty()) {
        if (log.back() == '\n') log.remove_suffix(1);
        const std::size_t start = log.rfind('\n') + 1;  // npos + 1 is 0
        const std::string_view line = log.substr(start);
        if (auto found = dated(line)) {
            found->message += after;
            return found;
        }
        if (!line.empty()) after.insert(0, "\n" + std::string(line));
        log = log.substr(0, start);
    }
    return std::nullopt;
}

std::optional<LogLine> last_line_of(const fs::path& log) { return last_line(end_of(log)); }

std::vector<std::string> last_lines_of(const fs::path& log, std::size_t most) {
    std::istringstream text(end_of(log));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
        lines.push_back(line);
        if (lines.size() > most) lines.erase(lines.begin());
    }
    return lines;
}

RunStanding judge_state(const RunSigns& signs) {
    const bool ended = starts_with(signs.log, "finished at"), stopped = starts_with(signs.log, "stopped at");
    const bool failed = signs.log && signs.log->level == "error";
    // A process that has told its end is about to give the lock back.
    if (signs.lock.holder && !(signs.results && (ended || stopped || failed))) {
        const std::string who = name_of(*signs.lock.holder) + " is at work on the run";
        if (!signs.results) return {RunState::waiting, who + "; it has not written results yet."};
        return {RunState::running, who + "."};
    }
    if (signs.results && ended) {
        return {RunState::finished,
                fmt::format("The run's log ended on {}: {}.", signs.log->when, signs.log->message)};
    }
    if (signs.results && stopped) {
        return {RunState::stopped,
                fmt::format("The run's log ended on {}: {}. `riffle resume` goes on from there.",
                            signs.log->when, signs.log->message)};
    }
    if (signs.results && failed) {
        return {RunState::failed,
                fmt::format("The run's log ended on {} with: {}", signs.log->when, signs.log->message)};
    }
    if (!signs.results) {
        return {RunState::waiting, "No results yet. This page goes on by itself as soon as there are some."};
    }
    if (signs.complete) return {RunState::finished, "The results file is marked as complete."};

    if (signs.lock.known) {
        return {RunState::lost,
                "No process is at work on the run any more, and its log does not tell of an end: it has been "
                "killed, or the machine has stopped. `riffle resume` goes on from its last checkpoint."};
    }
    const std::string none =
        "There is no lock that would tell whether a process is at work on the run, and its log does not tell "
        "of an end. ";
    const double age = signs.seconds_since_write.value_or(0.0);
    const std::string last = fmt::format("Results were last written {} ago, and are expected about every {}",
                                         duration(age), duration(signs.write_interval));
    if (age <= std::max(3 * signs.write_interval, shortest_patience)) {
        return {RunState::unseen, none + last + ": the run may go on elsewhere, or have been killed since."};
    }
    return {RunState::lost, none + last +
                                ": it has probably been killed, or the disk is full. `riffle resume` goes on "
                                "from its last checkpoint."};
}

}  // namespace riffle::inline watch
