#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "column/column.hpp"
#include "instruments/probe_set.hpp"
#include "output/dataset.hpp"
#include "output/results_file.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/series.hpp"
#include "solver/simulation.hpp"

namespace riffle {

/// Everything that a run records on the way: time series, surface, profile blocks, snapshots, and
/// the records of the instruments. What is due is
/// decided by the simulated time alone, so that a resumed run records the same rows.
class Recorder {
  public:
    Recorder(const Case& c, const ColumnResult* column);

    /// Time from which something is due that looks at the fields of the particles.
    [[nodiscard]] double fields_due() const;

    /// Record what is due at the present state. Call after the start and after each step.
    void record(const Simulation& simulation);

    [[nodiscard]] const TimeSeries& series() const { return series_; }
    [[nodiscard]] const ProfileSampler& profiles() const { return profiles_; }
    [[nodiscard]] double mean_level() const { return mean_level_; }
    [[nodiscard]] std::size_t snapshots() const { return snapshot_times_.size(); }
    [[nodiscard]] const std::vector<double>& snapshot_times() const { return snapshot_times_; }

    /// Bytes recorded since the last take_new_rows().
    [[nodiscard]] std::size_t pending_bytes() const;

    /// Rows recorded since the last call, as content for the results file.
    [[nodiscard]] Content take_new_rows();

    /// Number of rows of each appended dataset at the last take_new_rows(), for the checkpoint.
    [[nodiscard]] std::map<std::string, std::size_t> rows() const;

    /// State for the checkpoint: next due times and the block that is being filled.
    void save(Content& checkpoint) const;

    /// Put back the state of a checkpoint and the rows that the results file holds.
    void restore(const Content& checkpoint, const ResultsReader& results);

  private:
    struct Due {
        double series = 0.0, surface = 0.0, profile = 0.0, snapshot = 0.0;
    };
    void record_surface(double time, const FluidView& fluid);
    void record_probes(const Simulation& simulation, const FluidView* fluid);
    void record_snapshot(const Simulation& simulation);

    Case case_;
    TimeSeries series_;
    ProfileSampler profiles_;
    ProbeSet probes_;
    Due due_;
    std::vector<double> surface_x_;
    double mean_level_ = 0.0;
    bool has_surface_ = false;

    std::size_t taken_series_ = 0;
    std::size_t taken_blocks_ = 0;
    std::size_t surface_rows_ = 0;
    std::vector<double> new_surface_time_;
    std::vector<float> new_surface_;
    std::vector<double> snapshot_times_;
    Content new_snapshots_;
    std::size_t new_snapshot_bytes_ = 0;
};

/// The present state of a simulation, for instruments; `fluid`: of the same state, null where none looks at
/// it.
[[nodiscard]] FlowState flow_state(const Simulation& simulation, const FluidView* fluid);

/// Bytes of recorded data that may wait in memory before they are written out.
inline constexpr std::size_t pending_limit = std::size_t{256} << 20U;

/// Value of a scalar attribute of "/" in a checkpoint's content; throws FileError when it is missing.
[[nodiscard]] double checkpoint_number(const Content& content, const std::string& name);

/// A dataset of a checkpoint's content; throws FileError when it is missing.
[[nodiscard]] const Dataset& checkpoint_dataset(const Content& content, const std::string& path);

}  // namespace riffle
