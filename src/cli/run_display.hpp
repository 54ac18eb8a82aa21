#pragma once

#include <atomic>

#include "cli/status_line.hpp"
#include "solver/run.hpp"

namespace riffle {

/// The progress line of a run on standard error.
class RunDisplay {
  public:
    explicit RunDisplay(bool quiet);
    void show(const RunProgress& progress);
    /// End the line that is being rewritten.
    void finish();

  private:
    bool quiet_;
    StatusLine line_;
};

/// Turn SIGINT and SIGTERM into a flag; the returned flag holds the signal's number once one has come.
[[nodiscard]] const std::atomic<int>& catch_stop_signals();

/// Print what came out of a run and what to do next; sets the exit status after a stop by a signal.
void print_outcome(const RunOutcome& outcome, const Case& c, const RunFiles& files, bool quiet);

}  // namespace riffle
