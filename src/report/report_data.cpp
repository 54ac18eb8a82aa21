#include "report/report_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "column/column.hpp"

namespace riffle {

namespace {

constexpr std::array series_names = {"time",
                                     "depth_mean_velocity",
                                     "drag_over_gravity",
                                     "wall_over_gravity",
                                     "side_wall_over_gravity",
                                     "acceleration_over_gravity",
                                     "mean_level",
                                     "velocity_fluctuation",
                                     "particle_order",
                                     "density_deviation_minimum",
                                     "density_deviation_maximum",
                                     "kinetic_energy",
                                     "maximum_velocity",
                                     "total_mean_velocity"};

constexpr std::array summary_names = {"depth_mean_velocity",
                                      "depth_mean_velocity_half_width",
                                      "surface_velocity",
                                      "friction_velocity",
                                      "log_law_friction_velocity",
                                      "log_law_friction_velocity_half_width",
                                      "equivalent_roughness",
                                      "equivalent_roughness_half_width",
                                      "zero_plane",
                                      "drag_over_gravity",
                                      "wall_over_gravity",
                                      "side_wall_over_gravity",
                                      "centreline_velocity",
                                      "centreline_velocity_half_width",
                                      "simulated_time",
                                      "mean_level",
                                      "particles",
                                      "steps",
                                      "wall_clock_seconds",
                                      "particle_updates_per_second",
                                      "converged",
                                      "window_start",
                                      "window_end",
                                      "spurious_stress_rms",
                                      "stress_error_rms",
                                      "velocity_error_above_rms",
                                      "velocity_error_above_maximum",
                                      "velocity_error_below_rms",
                                      "velocity_error_below_maximum",
                                      "lost_particles",
                                      "lost_share"};

constexpr std::array column_value_names = {
    "depth_mean_velocity",  "total_mean_velocity", "surface_velocity",          "friction_velocity",
    "equivalent_roughness", "zero_plane",          "log_law_friction_velocity", "drag_share",
    "wall_share",           "relaxation_time"};

constexpr std::array section_value_names = {"depth_mean_velocity", "centreline_velocity", "drag_share",
                                            "side_wall_share"};

std::optional<double> number(const std::optional<AttributeValue>& value) {
    if (!value) return std::nullopt;
    if (const auto* real = std::get_if<double>(&*value)) return *real;
    if (const auto* integer = std::get_if<std::int64_t>(&*value)) return static_cast<double>(*integer);
    return std::nullopt;
}

std::string text(const std::optional<AttributeValue>& value) {
    if (value) {
        if (const auto* words = std::get_if<std::string>(&*value)) return *words;
    }
    return {};
}

template <typename Names>
Values read_values(const ResultsReader& reader, const std::string& group, const Names& names) {
    Values values;
    if (!reader.has(group)) return values;
    for (const char* name : names) {
        if (const auto value = number(reader.attribute(group, name)); value && std::isfinite(*value)) {
            values[name] = *value;
        }
    }
    return values;
}

void read_window(const ResultsReader& reader, ReportData& data) {
    const auto of = [&](const char* name) {
        if (reader.has("/profiles")) {
            if (const auto value = number(reader.attribute("/profiles", name))) return *value;
        }
        return find_value(data.summary, name).value_or(0.0);
    };
    data.window_start = of("window_start");
    data.window_end = of("window_end");
    data.profile_samples = of("samples");
}

/// Those of the named one-dimensional datasets of a group that exist.
template <typename Names>
Columns read_columns(const ResultsReader& reader, const std::string& group, const Names& names) {
    Columns columns;
    for (const char* name : names) {
        const std::string path = group + "/" + name;
        if (reader.has(path)) columns[name] = reader.read_doubles(path);
    }
    return columns;
}

/// Series of a run that was stopped between two appends may differ in length: keep the common rows.
Columns read_series(const ResultsReader& reader) {
    Columns columns = read_columns(reader, "/time_series", series_names);
    std::size_t rows = SIZE_MAX;
    for (const auto& [name, values] : columns) rows = std::min(rows, values.size());
    for (auto& [name, values] : columns) values.resize(rows);
    if (!has_column(columns, "time")) columns.clear();
    return columns;
}

/// Solve the column twin for those of its values that the results file lacks; nothing where the case has
/// none.
void complete_column(ReportData& data) {
    Values& values = data.column_summary;
    const bool whole = find_value(values, "depth_mean_velocity") &&
                       find_value(values, "log_law_friction_velocity") &&
                       find_value(values, "relaxation_time") && find_value(values, "drag_share");
    if (whole || !has_column(data.flow)) return;
    const ColumnResult column = solve_column(data.flow);
    values.try_emplace("depth_mean_velocity", column.depth_mean_velocity);
    values.try_emplace("surface_velocity", column.surface_velocity);
    values.try_emplace("friction_velocity", column.friction_velocity);
    values.try_emplace("drag_share", column.drag_share);
    values.try_emplace("wall_share", column.wall_share);
    if (std::isfinite(column.relaxation_time)) values.try_emplace("relaxation_time", column.relaxation_time);
    if (column.log_law.valid) {
        values.try_emplace("equivalent_roughness", column.log_law.equivalent_roughness);
        values.try_emplace("log_law_friction_velocity", column.log_law.friction_velocity);
    }
}

}  // namespace

std::optional<double> find_value(const Values& values, const std::string& name) {
    const auto found = values.find(name);
    if (found == values.end()) return std::nullopt;
    return found->second;
}

bool has_column(const Columns& columns, const std::string& name) {
    const auto found = columns.find(name);
    return found != columns.end() && !found->second.empty();
}

ReportData collect_report_data(const std::filesystem::path& results, FieldFrames frames) {
    const ResultsReader reader(results);
    ReportData data;
    data.source = results;
    data.riffle_version = text(reader.attribute("/", "riffle_version"));
    data.build = text(reader.attribute("/", "build"));
    data.created = text(reader.attribute("/", "created"));
    data.complete = number(reader.attribute("/", "complete")).value_or(0.0) != 0.0;
    if (!reader.has("/case/text")) {
        throw FileError(results.string() +
                        ": the results file holds no case (/case/text); the report cannot be made from it");
    }
    const std::string case_text = reader.read_string("/case/text");
    try {
        data.flow = parse_case(case_text, results.string() + ":/case/text");
    } catch (const InputError& error) {
        throw FileError(results.string() +
                        ": the case in the results file cannot be read by this version of Riffle:\n" +
                        error.what());
    }
    data.flow.text = case_text;
    data.title = text(reader.attribute("/", "title"));
    if (data.title.empty()) data.title = data.flow.title;
    if (data.title.empty()) data.title = "Open-channel flow";

    data.summary = read_values(reader, "/summary", summary_names);
    data.column_summary = read_values(reader, "/column", column_value_names);
    data.section_summary = read_values(reader, "/section", section_value_names);
    data.series = read_series(reader);
    complete_column(data);
    read_window(reader, data);
    data.field = read_field(reader, data.flow, frames);
    return data;
}

}  // namespace riffle
