#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "output/checkpoint_file.hpp"
#include "output/dataset.hpp"
#include "output/results_file.hpp"
#include "output/xdmf.hpp"
#include "record/particle_fields.hpp"
#include "solver/boundary_content.hpp"
#include "solver/simulation.hpp"

namespace riffle::inline solver {

/// Snapshots of the particles: those fields, of that part of the water, that [output] asks for.
class SnapshotRecorder {
  public:
    explicit SnapshotRecorder(const Case& c);

    /// Add a snapshot of the present state.
    template <int D>
    void record(const SimulationIn<D>& simulation);
    /// Add one of the state that a run ends in, unless there is one. It stands outside of the sequence: a run
    /// that is resumed forgets it, and has the snapshots of an uninterrupted one.
    template <int D>
    void record_last(const SimulationIn<D>& simulation);

    [[nodiscard]] const BoundaryContent& boundaries() const { return boundaries_; }
    /// Whether snapshots are made and hold the eddy viscosity.
    [[nodiscard]] bool shows_viscosity() const {
        return case_.output.snapshot_interval > 0.0 && has(fields::snapshot.eddy_viscosity);
    }

    /// The snapshots so far, and what each holds, for their index.
    [[nodiscard]] const std::vector<SnapshotEntry>& entries() const { return entries_; }
    [[nodiscard]] std::vector<SnapshotField> fields() const;
    /// Bytes that each particle of a snapshot takes.
    [[nodiscard]] std::size_t bytes_per_particle() const;

    /// Bytes recorded since the last take().
    [[nodiscard]] std::size_t pending_bytes() const { return new_bytes_; }
    /// What was recorded since the last call.
    [[nodiscard]] Content take();

    void save(Content& checkpoint) const;
    void restore(const CheckpointReader& checkpoint);
    /// Keep the snapshot of the state that the run ended in, at this time, where the results have one: for a
    /// run that is resumed and has nothing left to do.
    void keep_last(const ResultsReader& results, double time);

  private:
    struct Range {
        double from, to;
    };
    template <int D>
    [[nodiscard]] std::vector<std::uint32_t> chosen(const Particles<D>& particles) const;
    [[nodiscard]] bool has(const Field& field) const;
    /// The snapshot that has the list of points for one with so many particles: the first such one.
    [[nodiscard]] std::size_t points_in(std::size_t particles) const;

    Case case_;
    BoundaryContent boundaries_;
    std::vector<std::string> chosen_fields_;
    std::vector<SnapshotEntry> entries_;
    bool has_last_ = false;  ///< the last entry is that of record_last()
    Content new_;
    std::size_t new_bytes_ = 0;
};

}  // namespace riffle::inline solver
