#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "boundary/body_racks.hpp"
#include "ends/end_events.hpp"
#include "output/folder_lock.hpp"
#include "solver/recorder.hpp"
#include "solver/run.hpp"
#include "solver/run_log.hpp"
#include "solver/twins.hpp"

namespace riffle::inline solver {

/// One run in progress, in D dimensions: the simulation, what it records, and its files.
template <int D>
class RunSession {
  public:
    /// `lock`: of the folder of the run, held as long as the session lives.
    RunSession(Case c, RunOptions options, const FolderLock& lock);

    /// Run from t = 0: create the results file and the first checkpoint, advance to the end, writing on the
    /// way. What ends the run by an error is told in the log too.
    RunOutcome run();

    /// Go on from a checkpoint: check that everything belongs together, cut the results back to it, advance.
    /// `warnings`: what compare_identity() says of it.
    RunOutcome resume(const std::filesystem::path& checkpoint, const std::vector<std::string>& warnings);

  private:
    using Clock = std::chrono::steady_clock;

    /// When the results are written: a run that goes on leaves its last state to the checkpoint.
    enum class Moment { on_the_way, stopped, complete, failed };

    template <class F>
    RunOutcome logged(const F& f);
    void start();
    void restore(const std::filesystem::path& checkpoint, const std::vector<std::string>& warnings);
    /// Throws FileError where the folder was removed while the run went on: another run may be at work there.
    void require_own_folder() const;
    /// Say where a run that is gone on with is beyond its end.
    void tell_of_past_end();
    RunOutcome advance();
    void make_simulation_of_case(bool from_start);
    void step(double fields_due);
    /// Write what a run that fails leaves, and tell of it: the message of the error to be thrown.
    std::string leave_failure(const RunError& error);
    void write_out(Moment moment);
    void write_results(Moment moment);
    void write_checkpoint();
    void add_run_attributes(Content& content, Moment moment) const;
    void update_convergence(bool final_test);
    /// Whether the flow is tested for convergence.
    [[nodiscard]] bool is_tested() const;
    void report_progress();
    /// Time from which a step must bring the fields of the particles up to date.
    [[nodiscard]] double fields_due() const;
    /// Say which particles have left the domain since the last call.
    void report_losses();
    /// The same of what happens at open ends.
    void report_end_events();
    /// Write a warning into the log, and show it to who started the run.
    void tell(const std::string& warning);
    [[nodiscard]] LostWater lost() const;
    [[nodiscard]] bool finished() const;
    [[nodiscard]] double seconds_since(Clock::time_point t) const;

    Case case_;
    RunOptions options_;
    const FolderLock& lock_;
    RunFiles files_;
    RunLog log_;
    std::string run_id_;
    std::string inputs_;   ///< input_checksums() at the start of the run
    std::string failure_;  ///< what the simulation failed with
    Twins twins_;
    double relaxation_time_ = 0.0;  ///< s; 0 where there is no steady flow to come to
    std::unique_ptr<SimulationIn<D>> simulation_;
    std::unique_ptr<Recorder> recorder_;
    Convergence convergence_;
    double next_test_ = 1.0;
    double earlier_wall_seconds_ = 0.0;
    std::int64_t first_step_ = 0;
    std::size_t told_losses_ = 0;          ///< lost particles that the log knows of
    std::optional<EndEvents> end_events_;  ///< of open ends under a free surface
    RackWatch rack_watch_{case_};          ///< of free bodies between open ends
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_write_ = begin_;
    Clock::time_point last_progress_ = begin_;
    double write_seconds_ = 0.0;  ///< duration of the last write
};

extern template class RunSession<2>;
extern template class RunSession<3>;

}  // namespace riffle::inline solver
