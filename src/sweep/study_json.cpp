#include <optional>

#include "base/version.hpp"
#include "report/json_parts.hpp"
#include "sweep/study_files.hpp"

namespace riffle::inline sweep {

namespace {

constexpr int sweep_json_version = 1;

Json optional_number(const std::optional<double>& value) { return value ? exact(*value) : Json(nullptr); }

const char* word(OutcomeKind kind) {
    switch (kind) {
        case OutcomeKind::value:
            return "value";
        case OutcomeKind::departure:
            return "departure";
        case OutcomeKind::cost:
            break;
    }
    return "cost";
}

Json keys_json(const SweepStudy& sweep) {
    Json list = Json::array();
    for (const VariedKey& key : sweep.keys) {
        list.push_back({{"key", key.variation.key},
                        {"label", key.label},
                        {"unit", key.is_number() ? Json(key.unit) : Json(nullptr)},
                        {"refines", key.refines},
                        {"values", key.variation.values}});
    }
    return list;
}

Json outcomes_json(const SweepStudy& sweep) {
    Json list = Json::array();
    for (const Outcome& outcome : sweep.outcomes) {
        list.push_back({{"key", outcome.key},
                        {"label", outcome.label},
                        {"unit", outcome.unit},
                        {"shown_unit", outcome.shown_unit},
                        {"factor", outcome.factor},
                        {"kind", word(outcome.kind)}});
    }
    return list;
}

Json runs_json(const SweepStudy& sweep) {
    Json list = Json::array();
    for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
        const StudiedRun& run = sweep.runs[i];
        Json values = Json::object();
        Json numbers = Json::object();
        for (std::size_t k = 0; k < sweep.keys.size(); ++k) {
            const VariedKey& key = sweep.keys[k];
            values[key.variation.key] = run.run.combination.values[k];
            numbers[key.variation.key] = key.is_number() ? exact(key.numbers[i]) : Json(nullptr);
        }
        Json outcomes = Json::object();
        for (const Outcome& outcome : sweep.outcomes) {
            const OutcomeValue found = run.outcome(outcome.key);
            outcomes[outcome.key] = {{"value", exact(found.value)},
                                     {"half_width", exact(found.half_width)},
                                     {"twin", exact(found.twin)}};
        }
        list.push_back({{"name", run.run.combination.name},
                        {"folder", run.run.folder.filename().string()},
                        {"state", word(run.report.fate)},
                        {"message", run.report.message},
                        {"values", std::move(values)},
                        {"numbers", std::move(numbers)},
                        {"outcomes", std::move(outcomes)}});
    }
    return list;
}

Json refinement_json(const SweepStudy& sweep, const RefinementStudy& study) {
    Json json = {{"key", study.key}, {"outcome", study.outcome}, {"others", study.others}};
    Json runs = Json::array();
    Json sizes = Json::array();
    for (std::size_t i = 0; i < study.runs.size(); ++i) {
        runs.push_back(sweep.runs[study.runs[i]].run.combination.name);
        sizes.push_back(exact(study.values[i].size));
    }
    json["runs"] = std::move(runs);
    json["sizes"] = std::move(sizes);
    const GridConvergence none;
    const GridConvergence& found = study.convergence ? *study.convergence : none;
    json["refinement"] = study.convergence ? Json(word(found.refinement)) : Json(nullptr);
    json["order"] = optional_number(found.order);
    json["order_half_width"] = optional_number(found.order_half_width);
    json["limit"] = optional_number(found.limit);
    json["limit_half_width"] = optional_number(found.limit_half_width);
    json["finest_uncertainty"] = optional_number(found.finest_uncertainty);
    json["fine_grid_index"] = optional_number(found.fine_grid_index);
    json["fitted_exponent"] = study.power_law ? exact(study.power_law->exponent) : Json(nullptr);
    json["fitted_exponent_half_width"] =
        study.power_law ? optional_number(study.power_law->half_width) : Json(nullptr);
    json["finding"] = study.finding;
    return json;
}

}  // namespace

std::string sweep_json(const SweepStudy& sweep) {
    Json refinements = Json::array();
    for (const RefinementStudy& study : sweep.refinements) {
        refinements.push_back(refinement_json(sweep, study));
    }
    return json_text({{"format", "riffle-sweep"},
                      {"format_version", sweep_json_version},
                      {"riffle_version", version()},
                      {"title", sweep.title},
                      {"case", sweep.case_file},
                      {"keys", keys_json(sweep)},
                      {"outcomes", outcomes_json(sweep)},
                      {"runs", runs_json(sweep)},
                      {"refinements", std::move(refinements)}},
                     2) +
           "\n";
}

}  // namespace riffle::inline sweep
