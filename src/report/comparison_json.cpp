#include "base/version.hpp"
#include "report/comparison.hpp"
#include "report/cost.hpp"
#include "report/summary_json.hpp"

namespace riffle::inline report {

namespace {

Json differences_json(const std::vector<CaseDifference>& differences) {
    Json rows = Json::array();
    for (const CaseDifference& row : differences) {
        rows.push_back({{"key", row.key}, {"label", row.label}, {"values", row.values}});
    }
    return rows;
}

Json missing_json(const std::vector<MissingRun>& missing) {
    Json rows = Json::array();
    for (const MissingRun& row : missing) rows.push_back({{"what", row.what}, {"command", row.command}});
    return rows;
}

Json costs_json(const std::vector<ComparedRun>& runs) {
    Json rows = Json::array();
    for (const CostRow& row : cost_rows(runs)) {
        rows.push_back({{"key", row.key}, {"label", row.label}, {"values", row.values}});
    }
    return rows;
}

Json run_json(const ComparedRun& compared) {
    Json object = {{"name", compared.name}};
    if (!compared.run) {
        object["kind"] = "record";
        object["title"] = compared.analysis.source;
        object["source"] = compared.analysis.source;
        return object;
    }
    const ReportData& data = *compared.run;
    const std::vector<SummaryRow> quantities = summarize(data, compared.analysis);
    object["kind"] = "run";
    object["title"] = data.title;
    object["source"] = data.source.string();
    object["flow"] = flow_line(data);
    object["verdict"] = verdict_json(judge(data, quantities, diagnose(data, compared.analysis)));
    object["quantities"] = quantity_rows(quantities);
    return object;
}

Json sets_json(const std::vector<ComparedSet>& sets) {
    Json rows = Json::array();
    for (const ComparedSet& set : sets) {
        rows.push_back({{"title", set.title},
                        {"introduction", set.introduction},
                        {"members", set.members},
                        {"names", set.names},
                        {"side_by_side", set.side_by_side},
                        {"chapters", set.chapters}});
    }
    return rows;
}

}  // namespace

std::string comparison_page_json(const Comparison& comparison) {
    Json runs = Json::array();
    std::vector<Analysis> analyses;
    for (const ComparedRun& run : comparison.runs) {
        runs.push_back(run_json(run));
        analyses.push_back(run.analysis);
    }
    return json_text({{"title", comparison.title},
                      {"introduction", comparison.introduction},
                      {"runs", std::move(runs)},
                      {"differences", differences_json(comparison.differences)},
                      {"costs", costs_json(comparison.runs)},
                      {"sets", sets_json(comparison.sets)},
                      {"missing", missing_json(comparison.missing)},
                      {"references", references_json(cited_references(analyses, {comparison.introduction}))}},
                     -1);
}

std::string comparison_summary_json(const Comparison& comparison) {
    Json runs = Json::array();
    for (const ComparedRun& compared : comparison.runs) {
        Json object = {{"name", compared.name}, {"kind", compared.run ? "run" : "record"}};
        if (compared.run) {
            object.update(summary_object(*compared.run, compared.analysis));
        } else {
            object["title"] = compared.analysis.source;
            object["findings"] = findings_json(compared.analysis);
            object["warnings"] = compared.analysis.warnings;
        }
        runs.push_back(std::move(object));
    }
    return json_text({{"format", "riffle-report-comparison"},
                      {"title", comparison.title},
                      {"riffle_version", version()},
                      {"runs", std::move(runs)},
                      {"differences", differences_json(comparison.differences)},
                      {"missing", missing_json(comparison.missing)}},
                     2) +
           "\n";
}

}  // namespace riffle::inline report
