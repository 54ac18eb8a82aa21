#include "report/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <system_error>

#include "base/error.hpp"

namespace riffle::inline report {

namespace {

/// The last `count` parts of a path.
std::string end_of(const std::filesystem::path& path, std::ptrdiff_t count) {
    const auto size = std::distance(path.begin(), path.end());
    std::filesystem::path end;
    for (auto part = std::next(path.begin(), std::max<std::ptrdiff_t>(0, size - count)); part != path.end();
         ++part) {
        end /= *part;
    }
    return end.string();
}

/// What tells results of equal cases apart: the folder, or the file where it is not the usual one, with as
/// many of the folders above as it takes.
std::vector<std::string> places_of(const std::vector<std::filesystem::path>& results) {
    std::vector<std::filesystem::path> whole;
    std::ptrdiff_t longest = 1;
    for (const std::filesystem::path& path : results) {
        std::error_code error;
        const std::filesystem::path full = std::filesystem::absolute(path, error).lexically_normal();
        whole.push_back(path.filename() == "results.h5" ? full.parent_path() : full);
        longest = std::max(longest, std::distance(whole.back().begin(), whole.back().end()));
    }
    std::vector<std::string> places(whole.size());
    for (std::ptrdiff_t count = 1; count <= longest; ++count) {
        std::transform(whole.begin(), whole.end(), places.begin(),
                       [&](const std::filesystem::path& path) { return end_of(path, count); });
        if (std::set<std::string>(places.begin(), places.end()).size() == places.size()) break;
    }
    return places;
}

}  // namespace

std::vector<ComparedRun> collect_runs(const std::vector<ReportSubject>& subjects) {
    if (subjects.empty()) throw InputError("a comparison needs at least one run or laboratory record");
    std::vector<ComparedRun> runs;
    for (const ReportSubject& subject : subjects) {
        ComparedRun run{subject.analysis.name, std::nullopt, subject.analysis};
        if (!subject.results.empty()) {
            run.run = collect_report_data(subject.results, subject.analysis, FieldFrames::none);
        }
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
    std::vector<std::filesystem::path> results;
    for (const std::size_t member : members) {
        if (!runs[member].run) continue;
        cases.push_back(&runs[member].run->flow);
        results.push_back(runs[member].run->source);
    }
    const std::vector<std::string> of_cases = names_of_cases(cases, places_of(results));
    auto name = of_cases.begin();
    std::vector<std::string> names;
    std::vector<std::string> sources;
    for (const std::size_t member : members) {
        names.push_back(runs[member].run ? *name++ : runs[member].name);
        sources.push_back(runs[member].analysis.source);
    }
    // Records of the laboratory may share their names; their files tell them apart.
    return told_apart(names, sources);
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
    comparison.title = records == 0                  ? fmt::format("Comparison of {} runs", simulated)
                       : comparison.runs.size() == 1 ? comparison.runs.front().name
                       : simulated == 0
                           ? fmt::format("Comparison of {} laboratory records", records)
                           : fmt::format("Comparison of {} run{} and {} laboratory record{}", simulated,
                                         simulated == 1 ? "" : "s", records, records == 1 ? "" : "s");
    ComparedSet all;
    all.members.resize(comparison.runs.size());
    std::iota(all.members.begin(), all.members.end(), std::size_t{0});
    comparison.sets.push_back(std::move(all));
    return comparison;
}

}  // namespace riffle::inline report
