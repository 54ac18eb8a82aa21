#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// What the file of a laboratory record does not tell.
struct LaboratoryRecordOptions {
    std::filesystem::path case_file;           ///< the flow that was measured; empty: none
    std::optional<TimeWindow> window;          ///< of the record; unset: all of it
    std::optional<double> sampling_frequency;  ///< Hz, of a file without times
    std::filesystem::path calibration;         ///< CSV of levels and voltages of wave probes
};

/// A CSV file of a laboratory: a profile (a column z), points across a channel (a column y), a field or
/// frames of image velocimetry (x, z, u, w; or a folder of them), the velocities at a point (a column u and
/// times), or the records of wave probes (docs/laboratory-data.md). Heights of the file are above the datum;
/// with a case they become heights above the bed level. Throws FileError with line or column, InputError for
/// a window outside of the record.
class LaboratoryRecord final : public FlowRecord {
  public:
    explicit LaboratoryRecord(const std::filesystem::path& csv, const LaboratoryRecordOptions& options = {});
    ~LaboratoryRecord() override;

    [[nodiscard]] std::string name() const override;
    [[nodiscard]] std::string source() const override;
    [[nodiscard]] Origin origin() const override { return Origin::measured; }
    [[nodiscard]] const Case* flow() const override;
    [[nodiscard]] const ColumnResult* column() const override;
    [[nodiscard]] TimeWindow window() const override;
    [[nodiscard]] const Profiles& profiles() const override;
    [[nodiscard]] const std::vector<ElevationProbe>& elevation_probes() const override;
    [[nodiscard]] const std::vector<VelocityProbe>& velocity_probes() const override;
    [[nodiscard]] const std::vector<VelocityGrid>& velocity_grids() const override;
    [[nodiscard]] const std::vector<VelocityPlane>& velocity_planes() const override;
    [[nodiscard]] const SectionPoints& section_points() const override;
    [[nodiscard]] const SectionTwin& section_twin() const override;
    [[nodiscard]] std::vector<std::string> warnings() const override;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace riffle::inline analysis
