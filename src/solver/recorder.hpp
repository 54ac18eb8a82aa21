#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "instruments/probe_set.hpp"
#include "output/checkpoint_file.hpp"
#include "output/dataset.hpp"
#include "output/results_file.hpp"
#include "solver/mean_field.hpp"
#include "solver/profile_blocks.hpp"
#include "solver/series.hpp"
#include "solver/simulation.hpp"
#include "solver/snapshots.hpp"
#include "solver/twins.hpp"

namespace riffle::inline solver {

/// Bytes of recorded data that may wait in memory before they are written out.
inline constexpr std::size_t pending_limit = std::size_t{16} << 20U;

/// Everything that a run records on the way: time series, surface, profile blocks, snapshots, the records of
/// the instruments; in three dimensions the mean field and maps of the surface. What is due is decided by the
/// simulated time alone, so that a resumed run records the same rows.
class Recorder {
  public:
    /// `twins`: of the case; must outlive the recorder.
    Recorder(const Case& c, const Twins& twins);

    /// Time from which something is due that looks at the fields of the particles.
    [[nodiscard]] double fields_due() const;

    /// Record what is due at the present state. Call after the start and after each step. In three dimensions
    /// the fields of the simulation are freed once they have been looked at.
    template <int D>
    void record(SimulationIn<D>& simulation);

    /// Whether what waits should be written before the simulation goes on: it is much, or a window of the
    /// mean field is complete, which is then read from its sums.
    [[nodiscard]] bool should_be_written() const {
        return pending_bytes() > pending_limit || mean_field_.has_closed_window();
    }

    /// Record what belongs to the state that the run ends in: a last snapshot. Its fields must be up to date.
    template <int D>
    void record_end(const SimulationIn<D>& simulation) {
        snapshots_.record_last(simulation);
    }

    /// Keep that snapshot in the results of a run that is resumed and has nothing left to do.
    void keep_end(const ResultsReader& results, double time) { snapshots_.keep_last(results, time); }

    [[nodiscard]] const TimeSeries& series() const { return series_; }
    [[nodiscard]] const ProfileSampler& profiles() const { return profiles_; }
    [[nodiscard]] double mean_level() const { return mean_level_; }
    [[nodiscard]] const SnapshotRecorder& snapshots() const { return snapshots_; }
    [[nodiscard]] const MeanField& mean_field() const { return mean_field_; }

    /// Bytes recorded since the last take_new_rows().
    [[nodiscard]] std::size_t pending_bytes() const;

    /// Rows recorded since the last call, as content for the results file.
    [[nodiscard]] Content take_new_rows();

    /// Number of rows of each appended dataset at the last take_new_rows(), for the checkpoint.
    [[nodiscard]] std::map<std::string, std::size_t> rows() const;

    /// State for the checkpoint: next due times and the block that is being filled. Large arrays are read
    /// from the recorder while they are written.
    void save(Content& checkpoint) const;

    /// Put back the state of a checkpoint and the rows that the results file holds. Throws FileError where
    /// the checkpoint does not belong to this case, or the results do not reach as far as it.
    void restore(const CheckpointReader& checkpoint, const ResultsReader& results);

  private:
    struct Due {
        double series = 0.0, surface = 0.0, profile = 0.0, snapshot = 0.0, surface_map = 0.0;
    };
    /// Elevations at places in the plan, and the rows of them that are not yet taken.
    struct Elevations {
        std::vector<Vec<2>> places;
        std::size_t taken = 0;
        std::vector<double> time = {};
        std::vector<float> values = {};

        /// Add a row; gives its mean over the wet places, NaN where all are dry.
        double record(double time_now, const FluidView& fluid);
        /// Move the rows into the content, each of this shape.
        void take(Content& content, const Field& time_field, const Field& elevation_field,
                  std::vector<std::size_t> shape, int dimensions);
    };
    [[nodiscard]] bool has_maps() const { return has_surface_ && map_interval_ > 0.0; }

    Case case_;
    TimeSeries series_;
    ProfileSampler profiles_;
    ProbeSet probes_;
    Due due_;
    MeanField mean_field_;
    SnapshotRecorder snapshots_;
    std::vector<double> surface_x_, map_x_, map_y_;
    Elevations surface_, map_;
    double mean_level_ = 0.0;
    bool has_surface_ = false;
    double map_interval_ = 0.0;  ///< 0 in two dimensions

    std::size_t taken_series_ = 0;
    std::size_t taken_blocks_ = 0;
};

/// The present state of a simulation, for instruments; `fluid`: of the same state, null where none looks at
/// it.
template <int D>
[[nodiscard]] FlowState flow_state(const SimulationIn<D>& simulation, const FluidView* fluid);

/// Places of the map of the surface along an axis of the plan: two particle spacings apart, m.
[[nodiscard]] std::vector<double> surface_map_places(const Case& c, double extent);

}  // namespace riffle::inline solver
