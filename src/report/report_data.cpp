#include "report/report_data.hpp"

#include <cmath>

#include "base/not_a_number.hpp"
#include "column/column.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline report {

namespace {

/// Solve the column twin for those of its numbers that the results file lacks; nothing where the case has
/// none.
void complete_column(ReportData& data) {
    Numbers& numbers = data.column;
    const auto& of = fields::column_numbers;
    const bool whole = find_value(numbers, of.depth_mean_velocity) &&
                       find_value(numbers, of.log_law_friction_velocity) &&
                       find_value(numbers, of.relaxation_time) && find_value(numbers, of.drag_share);
    if (whole || !has_column(data.flow)) return;
    const ColumnResult column = solve_column(data.flow);
    const auto set = [&](const Field& field, double value) {
        if (!find_value(numbers, field)) numbers.set(field, value);
    };
    set(of.depth_mean_velocity, column.depth_mean_velocity);
    set(of.surface_velocity, column.surface_velocity);
    set(of.friction_velocity, column.friction_velocity);
    set(of.drag_share, column.drag_share);
    set(of.wall_share, column.wall_force_share);
    if (!data.flow.vegetation.empty()) set(of.vegetation_share, column.vegetation_share);
    if (!data.flow.porous.empty()) set(of.porous_share, column.porous_share);
    set(of.relaxation_time, column.relaxation_time);
    if (column.log_law.valid) {
        set(of.equivalent_roughness, column.log_law.equivalent_roughness);
        set(of.log_law_friction_velocity, column.log_law.friction_velocity);
    }
}

void take_window(const AskedWindow& asked, ReportData& data) {
    data.window_start = asked.from;
    data.window_end = asked.to;
    data.profile_samples = 0.0;  // of the run's own window
    // What this window has none of: intervals from too few samples, fits that are not valid.
    const auto& of = fields::summary;
    for (const Field& field :
         {of.depth_mean_velocity_half_width, of.centreline_velocity_half_width, of.surface_velocity,
          of.friction_velocity, of.log_law_friction_velocity, of.log_law_friction_velocity_half_width,
          of.equivalent_roughness, of.equivalent_roughness_half_width, of.zero_plane, of.spurious_stress_rms,
          of.spurious_stress_maximum, of.stress_error_rms}) {
        if (data.summary.find(field)) data.summary.set(field, not_a_number);
    }
    for (const auto& [name, value] : asked.summary.all()) data.summary.set(name, value);
}

}  // namespace

double recorded_time(const ReportData& data) {
    const std::vector<double>& time = data.series[fields::time_series.time];
    return time.empty() ? 0.0 : time.back();
}

ReportData collect_report_data(const std::filesystem::path& results, FieldFrames frames) {
    return collect_report_data(RunResults(results), frames);
}

ReportData collect_report_data(const RunResults& results, FieldFrames frames) {
    ReportData data;
    const auto& file = fields::file;
    data.source = results.path();
    data.riffle_version = results.text(file.riffle_version);
    data.build = results.text(file.build);
    data.created = results.text(file.created);
    data.complete = results.number(file.complete).value_or(0.0) != 0.0;
    data.failure = results.text(file.failure);
    data.flow = results.flow();
    data.title = results.text(file.title);
    if (data.title.empty()) data.title = data.flow.title;
    if (data.title.empty()) data.title = "Open-channel flow";

    data.summary = results.numbers(fields::groups::summary);
    data.column = results.numbers(fields::groups::column);
    data.section = results.numbers(fields::groups::section);
    data.series = results.series();
    complete_column(data);
    if (const auto window = results.averaging_window()) {
        data.window_start = window->first;
        data.window_end = window->second;
    }
    data.profile_samples = results.number(fields::profile_window.samples).value_or(0.0);
    data.field = read_field(results, data.flow, frames);
    if (frames == FieldFrames::all) data.surface_frames = read_surface_frames(results, data.flow);
    return data;
}

ReportData collect_report_data(const std::filesystem::path& results, const Analysis& analysis,
                               FieldFrames frames) {
    ReportData data = collect_report_data(results, frames);
    if (analysis.asked_window) take_window(*analysis.asked_window, data);
    return data;
}

}  // namespace riffle::inline report
