#pragma once

#include <chrono>
#include <vector>

#include "cli/status_line.hpp"
#include "solver/forecast.hpp"
#include "sweep/schedule.hpp"

namespace riffle::inline cli {

/// The progress line of a sweep on standard error, and a line on standard output for each run that ends.
class SweepDisplay {
  public:
    explicit SweepDisplay(bool quiet);
    void show(const SweepProgress& progress);
    void show_end(const SweepRun& run, const RunReport& report, bool resumed);
    /// Take back the line that is being rewritten.
    void clear();

  private:
    bool quiet_;
    StatusLine line_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The matrix of a sweep with what each run will take; nothing is forecast of those that are not to be run.
void print_matrix(const std::vector<SweepRun>& runs, const std::vector<FolderStanding>& standings,
                  const std::vector<std::optional<Forecast>>& forecasts, const Shares& shares);

}  // namespace riffle::inline cli
