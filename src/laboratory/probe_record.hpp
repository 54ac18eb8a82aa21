#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/csv_table.hpp"
#include "laboratory/probe_calibration.hpp"
#include "laboratory/record_repair.hpp"

namespace riffle::inline laboratory {

/// One wave probe of a record.
struct WaveProbe {
    std::string name;
    double x = 0;  ///< streamwise position, m; not a number if the file does not tell
    double y = 0;  ///< spanwise position, m
    std::optional<ProbeCalibration> calibration;  ///< of a probe that gave voltages
    std::vector<double> elevation;                ///< m; not a number where no value could be had
    RecordQuality quality;
};

/// Evenly sampled records of several wave probes.
struct ProbeRecord {
    std::filesystem::path source;
    std::string title;              ///< comment "# title: ..."; may be empty
    double start = 0;               ///< time of the first sample, s
    double sampling_frequency = 0;  ///< Hz
    std::vector<WaveProbe> probes;  ///< in the order of the columns
    std::vector<CsvComment> comments;
    std::vector<std::string> warnings;  ///< all that was missing, repaired or assumed

    [[nodiscard]] std::size_t samples() const { return probes.empty() ? 0 : probes.front().elevation.size(); }
    [[nodiscard]] double time(std::size_t sample) const {
        return start + static_cast<double>(sample) / sampling_frequency;
    }
};

/// What the file does not tell, or what shall count instead.
struct ProbeRecordOptions {
    std::optional<double> sampling_frequency;    ///< Hz; needed if the file has neither times nor frequency
    std::vector<ProbeDescription> probes;        ///< each entry counts before the file's
    std::vector<NamedCalibration> calibrations;  ///< count before lines that are given as offset and gain
    double time_tolerance = 0.1;                 ///< of the times, in sampling intervals
    RepairOptions repair;
};

/// Read a record of wave probes: a column per probe with voltages (V) or elevations (a length), beside a
/// column `t` or `time`, or a comment "# sampling_frequency: 100 Hz". Comments "# probe P1: x = 28 mm, offset
/// = -12.3 mm, gain = 20.4 mm/V" describe the probes. Voltages need a calibration. Missing values and rows,
/// spikes and their repair are counted for each probe and told in `warnings`. Throws FileError with line or
/// column, or InputError for options that name no column.
[[nodiscard]] ProbeRecord read_probe_record(const std::filesystem::path& path,
                                            const ProbeRecordOptions& options = {});

}  // namespace riffle::inline laboratory
