#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "solver/recorder.hpp"
#include "solver/run.hpp"
#include "solver/run_log.hpp"
#include "solver/twins.hpp"

namespace riffle {

/// One run in progress, in D dimensions: the simulation, what it records, and its files.
template <int D>
class RunSession {
  public:
    RunSession(Case c, RunOptions options);

    /// Start at t = 0: create the results file and the first checkpoint.
    void start();

    /// Continue from a checkpoint: cut the results back to it, restore everything.
    void resume(const std::filesystem::path& checkpoint);

    /// Advance to the end, writing on the way.
    RunOutcome advance();

  private:
    using Clock = std::chrono::steady_clock;

    void make_simulation_of_case(bool from_start);
    void write_out(bool complete);
    void write_checkpoint();
    void add_run_attributes(Content& content, bool complete) const;
    void update_convergence(bool final_test);
    void report_progress();
    [[nodiscard]] bool finished() const;
    [[nodiscard]] double seconds_since(Clock::time_point t) const;

    Case case_;
    RunOptions options_;
    RunFiles files_;
    RunLog log_;
    Twins twins_;
    std::unique_ptr<SimulationIn<D>> simulation_;
    std::unique_ptr<Recorder> recorder_;
    Convergence convergence_;
    double next_test_ = 1.0;
    double earlier_wall_seconds_ = 0.0;
    std::int64_t first_step_ = 0;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_write_ = begin_;
    Clock::time_point last_progress_ = begin_;
    double write_seconds_ = 0.0;  ///< duration of the last write
};

extern template class RunSession<2>;
extern template class RunSession<3>;

}  // namespace riffle
