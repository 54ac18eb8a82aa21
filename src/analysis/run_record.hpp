#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow_record.hpp"
#include "record/run_results.hpp"

namespace riffle::inline analysis {

/// What a user may ask of the record of a run.
struct RunRecordOptions {
    std::optional<TimeWindow> window;  ///< in place of the run's averaging window
    /// What the run is compared with: a measured profile in place of the case's, points of a cross-section, a
    /// field of velocities (measured_files.hpp).
    std::vector<std::filesystem::path> measured;
    /// Most values of the surface elevation, and of an instrument, that are read; of a longer record the last
    /// part. 8 bytes each, several times over during the analysis.
    std::size_t most_elevations = 8'000'000;
};

/// The results file of a run, read part by part, so that a file larger than the memory can be analysed: of
/// the surface only the window, of the snapshots some of those in it.
///
/// Throws FileError (missing, damaged, no case in it), InputError for a window outside of the run.
class RunRecord final : public FlowRecord {
  public:
    explicit RunRecord(const std::filesystem::path& results, RunRecordOptions options = {});
    ~RunRecord() override;

    /// The file itself, for what stands in it beside the record.
    [[nodiscard]] const RunResults& results() const;

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::string source() const override;
    [[nodiscard]] Origin origin() const override { return Origin::simulated; }
    [[nodiscard]] const Case* flow() const override;
    [[nodiscard]] const ColumnResult* column() const override;
    [[nodiscard]] std::optional<double> sound_speed() const override;
    [[nodiscard]] TimeWindow window() const override;
    [[nodiscard]] const SeriesTable& series() const override;
    [[nodiscard]] const Profiles& profiles() const override;
    [[nodiscard]] const SpaceTime& surface() const override;
    [[nodiscard]] const std::vector<ElevationProbe>& elevation_probes() const override;
    [[nodiscard]] const std::vector<VelocityProbe>& velocity_probes() const override;
    [[nodiscard]] const std::vector<VelocityGrid>& velocity_grids() const override;
    [[nodiscard]] const std::vector<VelocityPlane>& velocity_planes() const override;
    [[nodiscard]] const std::vector<ScalarProbe>& scalar_probes() const override;
    [[nodiscard]] const MeanFlow& mean_field() const override;
    [[nodiscard]] const EddiesAndNoise& eddies_and_noise() const override;
    [[nodiscard]] const SurfaceMaps& surface_maps() const override;
    [[nodiscard]] const SectionTwin& section_twin() const override;
    [[nodiscard]] const Measured& measured() const override;
    /// Whether an analysis has asked for what was measured.
    [[nodiscard]] bool is_compared() const;
    [[nodiscard]] std::vector<std::string> warnings() const override;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace riffle::inline analysis
