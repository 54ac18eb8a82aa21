#include "report/report_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydraulics/channel_laws.hpp"
#include "report/json_parts.hpp"
#include "report/run_facts.hpp"
#include "report/summary_json.hpp"

namespace riffle {

namespace {

Json object_of(const Columns& columns, std::size_t stride = 1) {
    Json object = Json::object();
    for (const auto& [name, values] : columns) object[name] = array_of(values, stride);
    return object;
}

Json geometry_json(const ReportData& data) {
    const Case& c = data.flow;
    return {{"slope", c.channel.slope},
            {"depth", c.channel.depth},
            {"length", c.channel.length},
            {"datum", c.datum()},
            {"crest", c.crest()},
            {"total_depth", c.total_depth()},
            {"mean_level", find_value(data.summary, "mean_level").value_or(c.total_depth())},
            {"spacing", c.numerics.spacing},
            {"rough", c.bed.kind == BedKind::spheres},
            {"periodic", c.channel.ends == Ends::periodic}};
}

Json profiles_json(const ReportData& data) {
    if (!has_column(data.profiles, "z")) return nullptr;
    Json object = object_of(data.profiles);
    object["window_start"] = data.window_start;
    object["window_end"] = data.window_end;
    object["samples"] = data.profile_samples;
    return object;
}

Json column_json(const ReportData& data) {
    if (data.column.empty() && data.column_summary.empty()) return nullptr;
    Json object = object_of(data.column);
    for (const auto& [name, value] : data.column_summary) object[name] = exact(value);
    return object;
}

Json measured_json(const ReportData& data) {
    const Measured& measured = data.flow.measured;
    Json object = {{"uniform", measured.uniform}, {"source", measured.source}};
    if (measured.depth_mean_velocity) object["depth_mean_velocity"] = *measured.depth_mean_velocity;
    if (data.measured_profile) {
        const MeasuredProfile& profile = *data.measured_profile;
        object["profile"] = {{"kind", profile.from_law ? "law" : "points"},
                             {"z", array_of(profile.z)},
                             {"velocity", array_of(profile.velocity)},
                             {"uncertainty", array_of(profile.uncertainty)}};
    }
    return object;
}

Json log_law_json(const ReportData& data) {
    const LogLawFit& fit = data.log_law;
    if (!fit.valid) return {{"valid", false}};
    return {{"valid", true},
            {"kappa", log_law_kappa},
            {"friction_velocity", fit.friction_velocity},
            {"friction_velocity_half_width", exact(fit.friction_velocity_half_width)},
            {"equivalent_roughness", fit.equivalent_roughness},
            {"equivalent_roughness_half_width", exact(fit.equivalent_roughness_half_width)},
            {"zero_plane", fit.zero_plane},
            {"from", fit.from},
            {"to", fit.to},
            {"residual_rms", exact(fit.residual_rms)},
            {"z", array_of(data.log_law_z)},
            {"velocity", array_of(data.log_law_velocity)}};
}

Json window_json(const ReportData& data) {
    Json object = {{"start", data.window_start}, {"end", data.window_end}};
    object["mean"] = exact(find_value(data.summary, "depth_mean_velocity").value_or(NAN));
    object["half_width"] = exact(find_value(data.summary, "depth_mean_velocity_half_width").value_or(NAN));
    return object;
}

Json series_json(const ReportData& data) {
    if (!has_column(data.series, "time")) return nullptr;
    // Every n-th row where a figure could not show more.
    constexpr std::size_t most_rows = 5000;
    const std::size_t stride = (data.series.at("time").size() + most_rows - 1) / most_rows;
    return object_of(data.series, std::max<std::size_t>(stride, 1));
}

Json surface_json(const ReportData& data) {
    if (!data.surface) return nullptr;
    Json elevation = Json::array();
    for (const auto& row : data.surface->elevation) {
        Json line = Json::array();
        // Waves are a thousandth of the level and less: keep nanometres, not six digits.
        for (const double value : row)
            line.push_back(std::isfinite(value) ? Json(std::round(value * 1e9) / 1e9) : Json(nullptr));
        elevation.push_back(std::move(line));
    }
    return {{"x", array_of(data.surface->x)},
            {"time", array_of(data.surface->time)},
            {"elevation", std::move(elevation)},
            {"mean_level", data.surface->mean_level},
            {"standard_deviation", data.surface->standard_deviation},
            {"velocity",
             exact(find_value(data.summary, "depth_mean_velocity")
                       .value_or(find_value(data.column_summary, "depth_mean_velocity").value_or(NAN)))}};
}

Json snapshot_json(const ReportData& data) {
    if (!data.snapshot) return nullptr;
    const Snapshot& snapshot = *data.snapshot;
    Json object = {{"time", snapshot.time},
                   {"spacing", data.flow.numerics.spacing},
                   {"x_end", snapshot.left_out ? snapshot.x_end : data.flow.channel.length},
                   {"left_out", snapshot.left_out},
                   {"x", array_of(snapshot.x)},
                   {"z", array_of(snapshot.z)},
                   {"velocity", array_of(snapshot.velocity)},
                   {"vertical_velocity", array_of(snapshot.vertical_velocity)},
                   {"pressure", array_of(snapshot.pressure)},
                   {"eddy_viscosity", array_of(snapshot.eddy_viscosity)},
                   {"surface", {{"x", array_of(snapshot.surface_x)}, {"z", array_of(snapshot.surface_z)}}}};
    if (snapshot.y) object["y"] = *snapshot.y;
    return object;
}

std::string summary_note(const ReportData& data) {
    std::string note =
        "The column twin is the steady one-dimensional solution of the same equations, closure and drag: "
        "what the "
        "particles would give with perfect numerics. ";
    if (data.flow.has_side_walls()) {
        note +=
            "Between side walls the twin's mean and centreline velocities and shares are those of the "
            "section "
            "twin, the steady flow over the cross-section; what was measured stands beside the centreline. ";
    }
    if (data.flow.bed.kind == BedKind::spheres) {
        note +=
            "The datum lies below the crests of the bed elements; depth-mean values are taken above it. "
            "Friction velocity "
            "and equivalent roughness from the fit: rough log law <i>u</i>/<i>u</i><sub>∗</sub> = "
            "ln((<i>z</i> − <i>z</i><sub>0</sub>)/<i>k</i><sub>s</sub>)/0.41 + 8.5 with <i>z</i><sub>0</sub> "
            "at the datum. ";
    }
    note +=
        "Channel numbers are for a wide channel: hydraulic radius = depth above the datum; those of the "
        "measured flow "
        "follow from its depth-mean velocity in the same way.";
    const auto measured = data.notes.find("measured");
    if (measured != data.notes.end()) note += " Note: " + measured->second;
    return note;
}

}  // namespace

std::string page_json(const ReportData& data, const Analysis& analysis) {
    const std::vector<Quantity> quantities = summarize(data, analysis);
    const std::vector<Diagnostic> diagnostics = diagnose(data);
    Json facts = Json::array();
    for (const Fact& fact : run_facts(data)) facts.push_back({{"label", fact.label}, {"value", fact.value}});
    const Json object = {{"kicker", flow_line(data)},
                         {"description", data.flow.description},
                         {"verdict", verdict_json(judge(data, quantities, diagnostics))},
                         {"quantities", quantity_rows(quantities)},
                         {"summary_note", summary_note(data)},
                         {"geometry", geometry_json(data)},
                         {"profiles", profiles_json(data)},
                         {"column", column_json(data)},
                         {"measured", measured_json(data)},
                         {"log_law", log_law_json(data)},
                         {"window", window_json(data)},
                         {"series", series_json(data)},
                         {"surface", surface_json(data)},
                         {"snapshot", snapshot_json(data)},
                         {"diagnostics", diagnostics_json(diagnostics)},
                         {"run", std::move(facts)},
                         {"notes", data.notes},
                         {"case_text", data.flow.text}};
    return json_text(object, -1);
}

}  // namespace riffle
