#pragma once

#include <atomic>

#include "cli/status_line.hpp"
#include "solver/run.hpp"

namespace riffle::inline cli {

/// The progress line of a run on standard error.
class RunDisplay {
  public:
    explicit RunDisplay(bool quiet);
    void show(const RunProgress& progress);
    /// Print a warning on a line of its own; the progress line goes on below it.
    void warn(const std::string& warning);
    /// End the line that is being rewritten.
    void finish();

  private:
    bool quiet_;
    StatusLine line_;
};

/// Turn the signals by which a person or a batch system ends a run (SIGINT, SIGTERM, SIGHUP, SIGXCPU,
/// SIGUSR1, SIGUSR2) into a flag, which holds the signal's number once one has come; leave alone those that
/// are ignored, as with nohup. A second signal of the kind ends the program at once. A terminal that is gone
/// (SIGPIPE) and the limit of a file's size (SIGXFSZ) end nothing by themselves any more: the write fails.
[[nodiscard]] const std::atomic<int>& catch_stop_signals();

/// Print what came out of a run and what to do next; sets the exit status after a stop by a signal.
void print_outcome(const RunOutcome& outcome, const Case& c, const RunFiles& files, bool quiet);

}  // namespace riffle::inline cli
