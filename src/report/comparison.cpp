#include "report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <system_error>

#include "base/error.hpp"

namespace riffle {

namespace {

/// What tells results of equal cases apart: the folder, or the file where it is not the usual one.
std::string place_of(const std::filesystem::path& results) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(results, error);
    return results.filename() == "results.h5" ? whole.parent_path().filename().string()
                                              : results.filename().string();
}

}  // namespace

std::vector<ComparedRun> collect_runs(const std::vector<ReportSubject>& subjects) {
    if (subjects.empty()) throw InputError("a comparison needs at least one run or laboratory record");
    std::vector<ComparedRun> runs;
    for (const ReportSubject& subject : subjects) {
        ComparedRun run{subject.analysis.name, std::nullopt, subject.analysis};
        if (!subject.results.empty()) run.run = collect_report_data(subject.results);
        runs.push_back(std::move(run));
    }
    std::vector<std::size_t> all(runs.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const std::vector<std::string> names = names_among(runs, all);
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].name = runs[i].analysis.name = names[i];
    return runs;
}

std::vector<std::string> names_among(const std::vector<ComparedRun>& runs,
                                     const std::vector<std::size_t>& members) {
    std::vector<const Case*> cases;
    std::vector<std::string> places;
    for (const std::size_t member : members) {
        if (!runs[member].run) continue;
        cases.push_back(&runs[member].run->flow);
        places.push_back(place_of(runs[member].run->source));
    }
    const std::vector<std::string> of_cases = names_of_cases(cases, places);
    auto name = of_cases.begin();
    std::vector<std::string> names;
    for (const std::size_t member : members) names.push_back(runs[member].run ? *name++ : runs[member].name);
    // Records of the laboratory may share their names; their files tell them apart.
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!runs[members[i]].run && std::count(names.begin(), names.end(), names[i]) > 1) {
            names[i] += " (" + runs[members[i]].analysis.source + ")";
        }
    }
    return names;
}

std::vector<CaseDifference> differences_of(const std::vector<ComparedRun>& runs) {
    std::vector<const Case*> cases;
    for (const ComparedRun& run : runs) {
        if (run.run) cases.push_back(&run.run->flow);
    }
    std::vector<CaseDifference> differences = case_differences(cases);
    for (CaseDifference& difference : differences) {
        std::vector<std::string> values;
        auto value = difference.values.begin();
        for (const ComparedRun& run : runs) values.push_back(run.run ? *value++ : std::string("–"));
        difference.values = std::move(values);
    }
    return differences;
}

Comparison compare(const std::vector<ReportSubject>& subjects) {
    Comparison comparison;
    comparison.runs = collect_runs(subjects);
    comparison.differences = differences_of(comparison.runs);
    const auto records = std::count_if(comparison.runs.begin(), comparison.runs.end(),
                                       [](const ComparedRun& run) { return !run.run; });
    const auto simulated = static_cast<std::ptrdiff_t>(comparison.runs.size()) - records;
    comparison.title = records == 0 ? fmt::format("Comparison of {} runs", simulated)
                       : simulated == 0
                           ? fmt::format("{} laboratory record{}", records, records == 1 ? "" : "s")
                           : fmt::format("Comparison of {} run{} and {} laboratory record{}", simulated,
                                         simulated == 1 ? "" : "s", records, records == 1 ? "" : "s");
    ComparedSet all;
    all.members.resize(comparison.runs.size());
    std::iota(all.members.begin(), all.members.end(), std::size_t{0});
    comparison.sets.push_back(std::move(all));
    return comparison;
}

}  // namespace riffle
