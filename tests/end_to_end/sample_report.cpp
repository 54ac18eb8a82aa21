// Writes pages of sample results and analyses, with every kind of figure, for the browser's tests:
//   sample_report DIR     leaves report.html, comparison.html, thesis.html, space.html (a run in three
//                         dimensions) and dimensions.html (it beside a run in two) with their summaries there

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "../unit/report/sample_analysis.hpp"
#include "analysis/chapters.hpp"
#include "analysis/run_record.hpp"
#include "report/report.hpp"
#include "report/thesis.hpp"
#include "sample_results.hpp"
#include "sample_space.hpp"

namespace {

riffle::ReportSubject subject(const std::filesystem::path& folder, const std::string& name, double scale,
                              const std::string& more = {}) {
    std::filesystem::create_directories(folder / name);
    riffle::testing::SampleOptions options;
    options.case_text = riffle::testing::sample_case() + more;
    riffle::testing::write_sample_results(folder / name / "results.h5", options);
    return {folder / name / "results.h5", riffle::testing::sample_analysis(name, scale)};
}

riffle::ReportSubject analysed(const std::filesystem::path& results) {
    return {results, riffle::analyse(riffle::RunRecord(results))};
}

/// A run in three dimensions with its own analysis.
riffle::ReportSubject in_space(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "space");
    riffle::testing::SampleSpace sample;
    sample.noise = 2e-3;
    riffle::testing::write_sample_space(folder / "space" / "results.h5", sample);
    return analysed(folder / "space" / "results.h5");
}

void write_pages(const std::filesystem::path& folder) {
    const riffle::ReportSubject first = subject(folder, "first", 1.0);
    const riffle::ReportSubject second = subject(folder, "second", 1.03, "\n[turbulence]\nlambda = 0.1\n");
    riffle::write_report(first.results, folder / "report.html", folder / "summary.json", first.analysis);
    const auto write = [&](const riffle::Comparison& comparison, const char* name) {
        riffle::write_comparison(comparison, folder / name, riffle::summary_beside(folder / name));
    };
    write(riffle::compare({first, second, {{}, riffle::testing::sample_record("flume")}}), "comparison.html");
    write(riffle::thesis_figures({first, second}), "thesis.html");
    const riffle::ReportSubject space = in_space(folder);
    riffle::write_report(space.results, folder / "space.html", folder / "space-summary.json", space.analysis);
    write(riffle::compare({analysed(first.results), space}), "dimensions.html");
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: sample_report DIR\n");
        return 2;
    }
    try {
        write_pages(arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
