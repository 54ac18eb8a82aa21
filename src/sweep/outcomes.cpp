#include "sweep/outcomes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/run_record.hpp"
#include "analysis/space_time.hpp"
#include "analysis/surface_parts.hpp"
#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "case/nearest.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "record/run_results.hpp"
#include "record/twin_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline sweep {

namespace {

constexpr const char* surface_deviation = "surface_standard_deviation";

/// Where the twin has the outcome, among the numbers of /column and /section.
struct TwinName {
    Field outcome;
    std::optional<Field> column, section;
};
const std::vector<TwinName>& twin_names() {
    const auto& of = fields::summary;
    const auto& column = fields::column_numbers;
    const auto& section = fields::section_numbers;
    static const std::vector<TwinName> names = {
        {of.depth_mean_velocity, column.depth_mean_velocity, section.depth_mean_velocity},
        {of.total_mean_velocity, column.total_mean_velocity, section.bulk_velocity},
        {of.centreline_velocity, std::nullopt, section.centreline_velocity},
        {of.surface_velocity, column.surface_velocity, std::nullopt},
        {of.friction_velocity, column.friction_velocity, std::nullopt},
        {of.log_law_friction_velocity, column.log_law_friction_velocity, std::nullopt},
        {of.equivalent_roughness, column.equivalent_roughness, std::nullopt},
        {of.drag_over_gravity, column.drag_share, section.drag_share},
        {of.wall_over_gravity, column.wall_share, section.wall_share},
        {of.side_wall_over_gravity, std::nullopt, section.side_wall_share},
        {of.vegetation_over_gravity, column.vegetation_share, section.vegetation_share},
        {of.porous_over_gravity, column.porous_share, section.porous_share},
    };
    return names;
}

/// Half-width of the mean of a series over the averaging window; not-a-number where there is none, or where
/// too few samples of it are independent to know.
double half_width_of_series(const RunResults& results, const std::string& name) {
    const auto all = fields_of(fields::time_series);
    const auto field = std::find_if(all.begin(), all.end(), [&](const Field& f) { return f.name == name; });
    if (field == all.end()) return not_a_number;
    const std::vector<double> time = results.values(fields::time_series.time);
    const std::vector<double> values = results.values(*field);
    const double from = results.number(fields::summary.window_start).value_or(not_a_number);
    std::vector<double> window;
    for (std::size_t i = 0; i < std::min(time.size(), values.size()); ++i) {
        if (time[i] >= from) window.push_back(values[i]);
    }
    constexpr std::size_t fewest = 4;
    if (window.size() < fewest) return not_a_number;
    return trusted_half_width(mean_with_confidence(window)).value_or(not_a_number);
}

double twin_of(const RunResults& results, const std::string& key) {
    const auto& names = twin_names();
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const TwinName& name) { return key == name.outcome.name; });
    if (found == names.end()) return not_a_number;
    // With side walls the section, not the column, is the twin.
    const std::optional<Field>& field = results.has(fields::groups::section) ? found->section : found->column;
    return field ? results.number(*field).value_or(not_a_number) : not_a_number;
}

OutcomeValue read_outcome(const RunResults& results, const Numbers& summary, const std::string& key) {
    OutcomeValue outcome;
    outcome.value = summary.value(key);
    if (!std::isfinite(outcome.value)) return outcome;
    outcome.twin = twin_of(results, key);
    outcome.half_width = summary.value(key + "_half_width");
    if (!std::isfinite(outcome.half_width)) outcome.half_width = half_width_of_series(results, key);
    return outcome;
}

/// The relative departure of a mean from the twin's is as uncertain as the mean.
void add_error_half_width(std::map<std::string, OutcomeValue>& outcomes, const std::string& mean) {
    const auto error = outcomes.find(mean + "_error");
    const auto value = outcomes.find(mean);
    if (error != outcomes.end() && value != outcomes.end() && value->second.twin != 0.0) {
        error->second.half_width = value->second.half_width / std::abs(value->second.twin);
    }
}

/// Friction and roughness of a channel with side walls are those around its centreline, as `riffle analyse`
/// finds them beside the same fits of the section twin: the mean over the width has no law to be fitted to.
void put_centreline(const std::filesystem::path& results, std::map<std::string, OutcomeValue>& outcomes) {
    const Analysis fits = analyse(RunRecord(results), "fits");
    const auto value_of = [&](const std::string& key) {
        const Finding* const finding = find_finding(fits, key);
        return finding == nullptr ? not_a_number : finding->value;
    };
    for (const char* const key : {"friction_velocity", "log_law_friction_velocity", "equivalent_roughness"}) {
        const Finding* const finding = find_finding(fits, key);
        if (finding == nullptr || find_finding(fits, "width_friction_velocity") == nullptr) {
            outcomes.erase(key);
            continue;
        }
        outcomes[key] = {finding->value, finding->half_width.value_or(not_a_number),
                         value_of(std::string("section_twin_") + key)};
    }
}

/// The fluctuation of the surface, as `riffle analyse` finds it.
OutcomeValue read_surface(const std::filesystem::path& results) {
    try {
        const RunRecord record(results);
        const DeviationEstimate deviation = standard_deviation(surface_fluctuation(record.surface()).line);
        return {deviation.value, deviation.half_width, not_a_number};
    } catch (const InputError&) {
        return {};  // no surface, or a record too short
    }
}

}  // namespace

const std::vector<Outcome>& known_outcomes() {
    using enum OutcomeKind;
    const auto& of = fields::summary;
    static const std::vector<Outcome> outcomes = {
        {of.depth_mean_velocity.name, "depth-mean velocity U", "m/s", "m/s", 1, value, true},
        {of.depth_mean_velocity_error.name, "departure of U from the twin", "1", "%", 100, departure, true},
        {of.total_mean_velocity.name, "mass-mean velocity", "m/s", "m/s", 1, value, false},
        {of.total_mean_velocity_error.name, "departure of the mass mean from the twin", "1", "%", 100,
         departure, false},
        {of.centreline_velocity.name, "depth-mean velocity on the centreline", "m/s", "m/s", 1, value, true},
        {of.secondary_velocity.name, "secondary velocity", "m/s", "mm/s", 1e3, value, false, true},
        {of.surface_velocity.name, "velocity at the surface", "m/s", "m/s", 1, value, false},
        {of.velocity_error_above_rms.name, "rms departure of u from the twin above the crest", "1", "%", 100,
         departure, true, true},
        {of.velocity_error_above_maximum.name, "largest departure of u from the twin above the crest", "1",
         "%", 100, departure, false, true},
        {of.velocity_error_below_rms.name, "rms departure of u from the twin below the crest", "1", "%", 100,
         departure, true, true},
        {of.velocity_error_below_maximum.name, "largest departure of u from the twin below the crest", "1",
         "%", 100, departure, false, true},
        {of.friction_velocity.name, "friction velocity u_*, from the stress", "m/s", "mm/s", 1e3, value, true,
         true},
        {of.log_law_friction_velocity.name, "friction velocity u_*, from the log law", "m/s", "mm/s", 1e3,
         value, false, true},
        {of.equivalent_roughness.name, "equivalent roughness k_s", "m", "mm", 1e3, value, false, true},
        {of.drag_over_gravity.name, "bed drag over weight component", "1", "1", 1, value, true},
        {of.wall_over_gravity.name, "wall force over weight component", "1", "1", 1, value, false},
        {of.side_wall_over_gravity.name, "side walls' drag over weight component", "1", "1", 1, value, false},
        {of.vegetation_over_gravity.name, "vegetation's drag over weight component", "1", "1", 1, value,
         false},
        {of.porous_over_gravity.name, "resistance of porous zones over weight component", "1", "1", 1, value,
         false},
        {of.mean_level.name, "mean surface level", "m", "mm", 1e3, value, true, true},
        {surface_deviation, "standard deviation of the surface", "m", "mm", 1e3, value, true, true},
        {of.spurious_stress_rms.name, "rms spurious stress over the crest's", "1", "%", 100, departure, true,
         true},
        {of.stress_error_rms.name, "rms departure of the stress over the crest's", "1", "%", 100, departure,
         false, true},
        {of.velocity_fluctuation.name, "rms velocity fluctuation", "m/s", "mm/s", 1e3, value, false, true},
        {of.particle_order.name, "order of the particles", "1", "1", 1, value, false, true},
        {of.particles.name, "particles", "1", "1", 1, cost, false},
        {of.steps.name, "time steps", "1", "1", 1, cost, false},
        {of.simulated_time.name, "simulated time", "s", "s", 1, value, false},
        {of.wall_clock_seconds.name, "computing time", "s", "s", 1, cost, true},
    };
    return outcomes;
}

std::vector<Outcome> chosen_outcomes(const std::vector<std::string>& keys) {
    std::vector<Outcome> chosen;
    if (keys.empty()) {
        std::copy_if(known_outcomes().begin(), known_outcomes().end(), std::back_inserter(chosen),
                     [](const Outcome& outcome) { return outcome.usual; });
        return chosen;
    }
    std::vector<std::string> names;
    for (const Outcome& outcome : known_outcomes()) names.push_back(outcome.key);
    for (const std::string& key : keys) {
        const auto found = std::find(names.begin(), names.end(), key);
        if (found == names.end()) {
            const auto meant = nearest_name(key, names);
            throw InputError(fmt::format("--outcome {}: unknown outcome{}; the outcomes are {}", key,
                                         meant ? fmt::format(": did you mean {}?", *meant) : "",
                                         fmt::join(names, ", ")));
        }
        const Outcome& outcome = known_outcomes()[static_cast<std::size_t>(found - names.begin())];
        const bool again =
            std::any_of(chosen.begin(), chosen.end(), [&](const Outcome& other) { return other.key == key; });
        if (!again) chosen.push_back(outcome);
    }
    return chosen;
}

std::map<std::string, OutcomeValue> read_outcomes(const std::filesystem::path& results) {
    const RunResults file(results);
    const Numbers summary = file.numbers(fields::groups::summary);
    std::map<std::string, OutcomeValue> outcomes;
    for (const Outcome& outcome : known_outcomes()) {
        const OutcomeValue found = outcome.key == surface_deviation
                                       ? read_surface(results)
                                       : read_outcome(file, summary, outcome.key);
        if (std::isfinite(found.value)) outcomes.emplace(outcome.key, found);
    }
    if (file.has(fields::groups::section)) put_centreline(results, outcomes);
    add_error_half_width(outcomes, fields::summary.depth_mean_velocity.name);
    add_error_half_width(outcomes, fields::summary.total_mean_velocity.name);
    return outcomes;
}

}  // namespace riffle::inline sweep
