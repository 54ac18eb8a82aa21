#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output/folder_lock.hpp"

namespace riffle::inline watch {

/// How a run stands, as far as its files and the processes of this machine tell.
enum class RunState {
    waiting,   ///< no results yet
    running,   ///< a process holds the lock of the run's folder
    finished,  ///< converged or at its end
    stopped,   ///< by a signal, with a checkpoint
    failed,    ///< the log ends with an error
    unseen,    ///< no lock to tell, but written not long ago: perhaps on another machine
    lost,      ///< no process holds the lock; or there is none, and nothing was written for long
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

/// The last lines of a log, of which only the end is read; empty if it cannot be read.
[[nodiscard]] std::vector<std::string> last_lines_of(const std::filesystem::path& log, std::size_t most);

/// What can be known of a run from outside.
struct RunSigns {
    bool results = false;   ///< whether the results file exists
    bool complete = false;  ///< its attribute `complete`
    std::optional<LogLine> log;
    FolderLock::Standing lock = {};             ///< of the run's folder
    std::optional<double> seconds_since_write;  ///< age of the results file, s
    double write_interval = 60.0;               ///< expected between two writes of the results, s
};

/// A state with the sentence that says what it rests on.
struct RunStanding {
    RunState state = RunState::waiting;
    std::string reason;
};

/// What the signs add up to. The lock counts most: it is held as long as the process lives. Then the log's
/// last word. Where there is no lock to look at, a run passes for lost when nothing has been written for
/// three intervals (at least 10 s).
[[nodiscard]] RunStanding judge_state(const RunSigns& signs);

}  // namespace riffle::inline watch
