#include "sweep/outcomes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/run_record.hpp"
#include "analysis/space_time.hpp"
#include "analysis/surface_parts.hpp"
#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "case/nearest.hpp"
#include "output/results_file.hpp"
#include "statistics/confidence.hpp"

namespace riffle {

namespace {

constexpr const char* surface_deviation = "surface_standard_deviation";

/// Where the twin has the outcome, in the attributes of /column and /section.
struct TwinName {
    const char* outcome;
    const char* column;
    const char* section;
};
constexpr TwinName twin_names[] = {
    {"depth_mean_velocity", "depth_mean_velocity", "depth_mean_velocity"},
    {"total_mean_velocity", "total_mean_velocity", "bulk_velocity"},
    {"centreline_velocity", nullptr, "centreline_velocity"},
    {"surface_velocity", "surface_velocity", nullptr},
    {"friction_velocity", "friction_velocity", nullptr},
    {"log_law_friction_velocity", "log_law_friction_velocity", nullptr},
    {"equivalent_roughness", "equivalent_roughness", nullptr},
    {"drag_over_gravity", "drag_share", "drag_share"},
    {"wall_over_gravity", "wall_share", nullptr},
    {"side_wall_over_gravity", nullptr, "side_wall_share"},
};

double number(const ResultsReader& reader, const std::string& group, const std::string& name) {
    if (!reader.has(group)) {
        return not_a_number;
    }
    const auto value = reader.attribute(group, name);
    if (!value) {
        return not_a_number;
    }
    if (const auto* const real = std::get_if<double>(&*value)) {
        return *real;
    }
    const auto* const integer = std::get_if<std::int64_t>(&*value);
    return integer != nullptr ? static_cast<double>(*integer) : not_a_number;
}

/// Half-width of the mean of a series over the averaging window; not-a-number where there is none.
double half_width_of_series(const ResultsReader& reader, const std::string& name) {
    const std::string path = "/time_series/" + name;
    if (!reader.has(path)) {
        return not_a_number;
    }
    const std::vector<double> time = reader.read_doubles("/time_series/time");
    const std::vector<double> values = reader.read_doubles(path);
    const double from = number(reader, "/summary", "window_start");
    std::vector<double> window;
    for (std::size_t i = 0; i < std::min(time.size(), values.size()); ++i) {
        if (time[i] >= from) {
            window.push_back(values[i]);
        }
    }
    constexpr std::size_t fewest = 4;
    return window.size() < fewest ? not_a_number : mean_with_confidence(window).half_width;
}

double twin_of(const ResultsReader& reader, const std::string& key) {
    const auto* const found = std::find_if(std::begin(twin_names), std::end(twin_names),
                                           [&](const TwinName& name) { return key == name.outcome; });
    if (found == std::end(twin_names)) {
        return not_a_number;
    }
    // With side walls the section, not the column, is the twin.
    if (reader.has("/section")) {
        return found->section != nullptr ? number(reader, "/section", found->section) : not_a_number;
    }
    return found->column != nullptr ? number(reader, "/column", found->column) : not_a_number;
}

OutcomeValue read_outcome(const ResultsReader& reader, const std::string& key) {
    OutcomeValue outcome;
    outcome.value = number(reader, "/summary", key);
    if (!std::isfinite(outcome.value)) {
        return outcome;
    }
    outcome.twin = twin_of(reader, key);
    outcome.half_width = number(reader, "/summary", key + "_half_width");
    if (!std::isfinite(outcome.half_width)) {
        outcome.half_width = half_width_of_series(reader, key);
    }
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
    static const std::vector<Outcome> outcomes = {
        {"depth_mean_velocity", "depth-mean velocity U", "m/s", "m/s", 1, value, true},
        {"depth_mean_velocity_error", "departure of U from the twin", "1", "%", 100, departure, true},
        {"total_mean_velocity", "mass-mean velocity", "m/s", "m/s", 1, value, false},
        {"total_mean_velocity_error", "departure of the mass mean from the twin", "1", "%", 100, departure,
         false},
        {"centreline_velocity", "depth-mean velocity on the centreline", "m/s", "m/s", 1, value, true},
        {"secondary_velocity", "secondary velocity", "m/s", "mm/s", 1e3, value, false, true},
        {"surface_velocity", "velocity at the surface", "m/s", "m/s", 1, value, false},
        {"velocity_error_above_rms", "rms departure of u from the twin above the crest", "1", "%", 100,
         departure, true, true},
        {"velocity_error_above_maximum", "largest departure of u from the twin above the crest", "1", "%",
         100, departure, false, true},
        {"velocity_error_below_rms", "rms departure of u from the twin below the crest", "1", "%", 100,
         departure, true, true},
        {"velocity_error_below_maximum", "largest departure of u from the twin below the crest", "1", "%",
         100, departure, false, true},
        {"friction_velocity", "friction velocity u_*, from the stress", "m/s", "mm/s", 1e3, value, true,
         true},
        {"log_law_friction_velocity", "friction velocity u_*, from the log law", "m/s", "mm/s", 1e3, value,
         false, true},
        {"equivalent_roughness", "equivalent roughness k_s", "m", "mm", 1e3, value, false, true},
        {"drag_over_gravity", "bed drag over weight component", "1", "1", 1, value, true},
        {"wall_over_gravity", "wall force over weight component", "1", "1", 1, value, false},
        {"side_wall_over_gravity", "side walls' drag over weight component", "1", "1", 1, value, false},
        {"mean_level", "mean surface level", "m", "mm", 1e3, value, true, true},
        {surface_deviation, "standard deviation of the surface", "m", "mm", 1e3, value, true, true},
        {"spurious_stress_rms", "rms spurious stress over the crest's", "1", "%", 100, departure, true, true},
        {"stress_error_rms", "rms departure of the stress over the crest's", "1", "%", 100, departure, false,
         true},
        {"velocity_fluctuation", "rms velocity fluctuation", "m/s", "mm/s", 1e3, value, false, true},
        {"particle_order", "order of the particles", "1", "1", 1, value, false, true},
        {"particles", "particles", "1", "1", 1, cost, false},
        {"steps", "time steps", "1", "1", 1, cost, false},
        {"simulated_time", "simulated time", "s", "s", 1, value, false},
        {"wall_clock_seconds", "computing time", "s", "s", 1, cost, true},
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
    for (const Outcome& outcome : known_outcomes()) {
        names.push_back(outcome.key);
    }
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
        if (!again) {
            chosen.push_back(outcome);
        }
    }
    return chosen;
}

std::map<std::string, OutcomeValue> read_outcomes(const std::filesystem::path& results) {
    const ResultsReader reader(results);
    std::map<std::string, OutcomeValue> outcomes;
    for (const Outcome& outcome : known_outcomes()) {
        const OutcomeValue found =
            outcome.key == surface_deviation ? read_surface(results) : read_outcome(reader, outcome.key);
        if (std::isfinite(found.value)) {
            outcomes.emplace(outcome.key, found);
        }
    }
    if (reader.has("/section")) {
        put_centreline(results, outcomes);
    }
    add_error_half_width(outcomes, "depth_mean_velocity");
    add_error_half_width(outcomes, "total_mean_velocity");
    return outcomes;
}

}  // namespace riffle
