#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "hydraulics/log_law.hpp"
#include "output/results_file.hpp"

namespace riffle {

/// Named columns of equal length, SI; a column that the results file lacks is absent.
using Columns = std::map<std::string, std::vector<double>>;

/// Attributes of a group that are numbers.
using Values = std::map<std::string, double>;

/// Measured profile to draw.
struct MeasuredProfile {
    bool from_law = false;            ///< the log law of the measured u_* and k_s; otherwise points
    std::vector<double> z;            ///< above the bed level, m
    std::vector<double> velocity;     ///< m/s
    std::vector<double> uncertainty;  ///< m/s; empty if not given
};

/// Surface elevation over the last stretch of the record that the space-time map shows.
struct SurfaceRecord {
    std::vector<double> x;                       ///< m
    std::vector<double> time;                    ///< s
    std::vector<std::vector<double>> elevation;  ///< [time][x], above the bed level, m
    double mean_level = 0;                       ///< of the stretch, m
    double standard_deviation = 0;  ///< of the elevation about its mean, over the averaging window, m
};

/// Particles of one snapshot.
struct Snapshot {
    double time = 0;
    std::vector<double> x, z, velocity, vertical_velocity, pressure, eddy_viscosity;
    std::vector<double> surface_x, surface_z;  ///< free surface at the nearest recorded time; may be empty
    double x_end = 0;                          ///< particles with x below this are included, m
    bool left_out = false;                     ///< whether that leaves some out
    std::optional<double> y;                   ///< three dimensions: place across the channel of the slice, m
};

/// All that the report shows, collected from one results file. What the file lacks is empty.
struct ReportData {
    std::filesystem::path source;
    std::string title, riffle_version, build, created;
    bool complete = false;
    Case flow;  ///< the case, from its text in the file
    Values summary, column_summary;
    Values section_summary;  ///< of the section twin, between side walls
    Columns series, profiles, column;
    double window_start = 0, window_end = 0;  ///< averaging window, s; both 0 before there is one
    double profile_samples = 0;
    LogLawFit log_law;  ///< fit of the simulated profile; not valid for smooth beds or without profiles
    std::vector<double> log_law_z, log_law_velocity;
    std::optional<MeasuredProfile> measured_profile;
    std::optional<SurfaceRecord> surface;
    std::optional<Snapshot> snapshot;
    std::map<std::string, std::string> notes;  ///< why a figure cannot be drawn, by the figure's name
};

/// Collect the report's data. Throws FileError if the file's case is missing or cannot be read.
[[nodiscard]] ReportData collect_report_data(const std::filesystem::path& results);

/// The value with this name; nothing if absent or not finite.
[[nodiscard]] std::optional<double> find_value(const Values& values, const std::string& name);

/// Whether the column exists and is not empty.
[[nodiscard]] bool has_column(const Columns& columns, const std::string& name);

}  // namespace riffle
