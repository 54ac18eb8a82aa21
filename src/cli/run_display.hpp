#pragma once

#include <atomic>
#include <chrono>

#include "solver/run.hpp"

namespace riffle {

/// The progress line of a run on standard error: rewritten in place on a terminal, a line every 10 s
/// elsewhere.
class RunDisplay {
  public:
    explicit RunDisplay(bool quiet);
    void show(const RunProgress& progress);
    /// End the line that is being rewritten.
    void finish();

  private:
    bool quiet_;
    bool terminal_;
    bool open_line_ = false;
    std::chrono::steady_clock::time_point last_line_{};
};

/// Turn SIGINT and SIGTERM into a flag; the returned flag holds the signal's number once one has come.
[[nodiscard]] const std::atomic<int>& catch_stop_signals();

/// Print what came out of a run and what to do next; sets the exit status after a stop by a signal.
void print_outcome(const RunOutcome& outcome, const Case& c, const RunFiles& files, bool quiet);

}  // namespace riffle
