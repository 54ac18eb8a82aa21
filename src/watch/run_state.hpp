#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace riffle {

/// How a run stands, as far as its files and the processes of this machine tell.
enum class RunState {
    waiting,   ///< no results yet
    running,   ///< a process of this machine writes the run's log
    finished,  ///< converged or at its end
    stopped,   ///< by a signal, with a checkpoint
    failed,    ///< the log ends with an error
    unseen,    ///< no process seen, but written not long ago: perhaps on another machine
    lost,      ///< no process seen and nothing written for long
};

/// The word of a state, as the page and its data use it.
[[nodiscard]] const char* word(RunState state);

/// A line of a run's log (solver/run_log.hpp).
struct LogLine {
    std::string when;   ///< local date and time, as written
    std::string level;  ///< info, warning, error
    std::string message;

    bool operator==(const LogLine&) const = default;
};

/// The last line with a date in the text of a log, with the undated lines behind it; nothing if there is
/// none.
[[nodiscard]] std::optional<LogLine> last_line(std::string_view log);

/// The same of a file, of which only the end is read; nothing if it cannot be read.
[[nodiscard]] std::optional<LogLine> last_line_of(const std::filesystem::path& log);

/// The process that has a file open for writing, among those of this machine that this user may look into
/// (Linux's /proc); nothing if there is none. `guess` is looked at first.
[[nodiscard]] std::optional<int> find_writer(const std::filesystem::path& file,
                                             std::optional<int> guess = {});

/// What can be known of a run from outside.
struct RunSigns {
    bool results = false;   ///< whether the results file exists
    bool complete = false;  ///< its attribute `complete`
    std::optional<LogLine> log;
    std::optional<int> writer;                  ///< process that writes the log
    std::optional<double> seconds_since_write;  ///< age of the results file, s
    double write_interval = 60.0;               ///< expected between two writes of the results, s
};

/// A state with the sentence that says what it rests on.
struct RunStanding {
    RunState state = RunState::waiting;
    std::string reason;
};

/// What the signs add up to. The log's last word counts for more than `complete`, which a resumed run leaves
/// at 1 until it first writes. Without a process in sight a run passes for lost when nothing has been written
/// for three intervals (at least 10 s).
[[nodiscard]] RunStanding judge_state(const RunSigns& signs);

}  // namespace riffle
