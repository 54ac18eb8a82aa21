#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "statistics/linear_fit.hpp"

namespace riffle::inline laboratory {

/// Calibration line of a wave probe: elevation = offset + gain * voltage.
struct ProbeCalibration {
    double offset = 0;  ///< m
    double gain = 0;    ///< m/V
    // Of a line that was fitted; zero and empty for one that was given.
    std::size_t points = 0;
    double offset_half_width = 0;  ///< 95 %, m
    double gain_half_width = 0;    ///< 95 %, m/V
    double residual_rms = 0;       ///< m
    double lowest_voltage = 0;     ///< range of the calibration, V
    double highest_voltage = 0;
    std::optional<LinearFit> fit;  ///< coefficients offset, gain

    [[nodiscard]] double elevation(double voltage) const { return offset + gain * voltage; }

    /// 95 % half-width of the elevation of a voltage, from the scatter of the calibration alone; 0 for a line
    /// that was given.
    [[nodiscard]] double elevation_half_width(double voltage) const;
};

/// Least-squares line of levels (m) over voltages (V), the levels being exact to within scatter as of a
/// point gauge. Throws InputError for fewer than three points or one voltage.
[[nodiscard]] ProbeCalibration fit_probe_calibration(std::span<const double> voltages,
                                                     std::span<const double> levels);

/// Calibrations from a CSV file with the columns `level` (a length) and one of voltages per probe, named as
/// the probes. Missing values are passed over. Throws FileError naming line or column.
struct NamedCalibration {
    std::string probe;
    ProbeCalibration calibration;
};
[[nodiscard]] std::vector<NamedCalibration> read_probe_calibrations(const std::filesystem::path& path);

/// What is known of a probe beforehand: "P1: x = 28 mm, y = 0 mm, offset = -12.3 mm, gain = 20.4 mm/V", in a
/// comment of the file or on the command line. All but the name may be left out.
struct ProbeDescription {
    std::string name;
    std::optional<double> x, y;          ///< m
    std::optional<double> offset, gain;  ///< m, m/V
};

/// Throws InputError saying what was expected where the text is something else. A number without unit is in
/// SI.
[[nodiscard]] ProbeDescription parse_probe_description(std::string_view text);

}  // namespace riffle::inline laboratory
