#include "report/profile_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <system_error>

#include "base/error.hpp"
#include "column/column.hpp"
#include "column/velocity_measurements.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle {

namespace {

constexpr std::array profile_names = {"z",
                                      "bin_upper",
                                      "velocity",
                                      "velocity_half_width",
                                      "velocity_deviation",
                                      "column_velocity",
                                      "velocity_gradient",
                                      "eddy_viscosity",
                                      "pressure",
                                      "density",
                                      "viscous_stress",
                                      "pair_stress",
                                      "reynolds_stress",
                                      "total_stress",
                                      "analytic_stress"};

constexpr std::array column_names = {
    "z", "velocity", "velocity_gradient", "shear_stress", "mixing_length", "eddy_viscosity"};

constexpr std::size_t most_column_points = 600;

/// Remove columns whose length differs from that of z, and the rows of empty bins (z not finite).
void keep_whole_rows(Columns& columns) {
    const auto z = columns.find("z");
    if (z == columns.end()) {
        columns.clear();
        return;
    }
    const std::vector<double> heights = z->second;
    for (auto it = columns.begin(); it != columns.end();) {
        it = it->second.size() == heights.size() ? std::next(it) : columns.erase(it);
    }
    for (auto& [name, values] : columns) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < heights.size(); ++i) {
            if (std::isfinite(heights[i])) values[kept++] = values[i];
        }
        values.resize(kept);
    }
}

std::vector<double> law_heights(double zero_plane, double lowest, double top) {
    // Equal steps of ln(z - z_0), which the semi-logarithmic figure shows as equal steps.
    constexpr int count = 80;
    std::vector<double> heights;
    heights.reserve(count);
    const double low = std::log(std::max(lowest - zero_plane, 1e-3 * (top - zero_plane)));
    const double high = std::log(top - zero_plane);
    for (int i = 0; i < count; ++i)
        heights.push_back(zero_plane + std::exp(low + (high - low) * i / (count - 1)));
    return heights;
}

/// Whether the measured profile's file exists, at the place that the case names or beside the results file
/// (results are moved to other machines); the case then names the place where it is. Else a note says so.
bool find_measured_file(ReportData& data) {
    std::filesystem::path& path = data.flow.measured.velocity_profile;
    if (path.empty()) return false;
    std::error_code error;
    for (const auto& candidate :
         {path, data.source.parent_path() / path, data.source.parent_path() / path.filename()}) {
        if (!std::filesystem::is_regular_file(candidate, error)) continue;
        path = candidate;
        return true;
    }
    data.notes["measured"] = "the file of the measured profile, " + path.string() +
                             ", was found neither there nor beside the results file, so it is not drawn.";
    return false;
}

/// Height of the surface above the bed level: the run's mean level, before there is one the case's depth.
double surface_height(const ReportData& data) {
    return find_value(data.summary, "mean_level").value_or(data.flow.total_depth());
}

}  // namespace

Columns read_profiles(const ResultsReader& reader) {
    Columns columns = read_columns(reader, "/profiles", profile_names);
    keep_whole_rows(columns);
    return columns;
}

Columns read_column(const ResultsReader& reader) {
    Columns columns = read_columns(reader, "/column", column_names);
    keep_whole_rows(columns);
    if (!has_column(columns, "z") || columns["z"].size() <= most_column_points) return columns;
    // The column's grid is far finer than a figure can show; its own points are kept, every n-th.
    const std::size_t stride = (columns["z"].size() + most_column_points - 1) / most_column_points;
    for (auto& [name, values] : columns) {
        std::vector<double> thinned;
        for (std::size_t i = 0; i < values.size(); i += stride) thinned.push_back(values[i]);
        if ((values.size() - 1) % stride != 0) thinned.push_back(values.back());
        values = thinned;
    }
    return columns;
}

void add_hydrostatic_pressure(ReportData& data) {
    if (!has_column(data.profiles, "z")) return;
    const double surface = surface_height(data);
    const double weight = data.flow.fluid.density * data.flow.normal_gravity();
    std::vector<double> pressure;
    for (const double z : data.profiles.at("z")) pressure.push_back(weight * std::max(0.0, surface - z));
    data.profiles["hydrostatic_pressure"] = pressure;
}

void add_log_law(ReportData& data) {
    if (data.flow.bed.kind != BedKind::spheres || !has_column(data.profiles, "velocity")) return;
    const double zero_plane = data.flow.datum();
    const HeightRange range = log_law_range(data.flow);
    data.log_law = fit_log_law(data.profiles.at("z"), data.profiles.at("velocity"), log_law_kappa, zero_plane,
                               range.from, range.to);
    if (!data.log_law.valid) return;
    data.log_law_z = law_heights(zero_plane, data.flow.datum(), surface_height(data));
    for (const double z : data.log_law_z) {
        data.log_law_velocity.push_back(
            rough_log_law(z - zero_plane, data.log_law.friction_velocity, data.log_law.equivalent_roughness));
    }
}

void complete_column(ReportData& data) {
    Values& values = data.column_summary;
    const bool whole = find_value(values, "depth_mean_velocity") &&
                       find_value(values, "log_law_friction_velocity") &&
                       find_value(values, "relaxation_time") && find_value(values, "drag_share");
    if (whole && has_column(data.column, "z")) return;
    try {
        const ColumnResult column = solve_column(data.flow);
        values.try_emplace("depth_mean_velocity", column.depth_mean_velocity);
        values.try_emplace("surface_velocity", column.surface_velocity);
        values.try_emplace("friction_velocity", column.friction_velocity);
        values.try_emplace("drag_share", column.drag_share);
        values.try_emplace("wall_share", column.wall_share);
        if (std::isfinite(column.relaxation_time))
            values.try_emplace("relaxation_time", column.relaxation_time);
        if (column.log_law.valid) {
            values.try_emplace("equivalent_roughness", column.log_law.equivalent_roughness);
            values.try_emplace("log_law_friction_velocity", column.log_law.friction_velocity);
        }
        if (!has_column(data.column, "z")) {
            data.column["z"] = column.profile.z;
            data.column["velocity"] = column.profile.velocity;
            data.column["velocity_gradient"] = column.profile.velocity_gradient;
            data.column["shear_stress"] = column.profile.shear_stress;
        }
    } catch (const InputError&) {
        // The case has no steady uniform flow (a tank, a wave): there is no twin to compare with.
    }
}

std::optional<MeasuredProfile> measured_profile(ReportData& data) {
    VelocityMeasurements measurements;
    const bool from_file = find_measured_file(data);
    if (from_file) {
        measurements = read_velocity_measurements(data.flow);
    } else {
        constexpr int points = 60;
        measurements = measured_log_law(data.flow, points);
    }
    if (measurements.height.empty()) return std::nullopt;
    return MeasuredProfile{!from_file, measurements.height, measurements.velocity, measurements.uncertainty};
}

}  // namespace riffle
