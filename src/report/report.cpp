#include "report/report.hpp"

#include <string>
#include <system_error>
#include <vector>

#include "analysis/analysis_json.hpp"
#include "base/error.hpp"
#include "base/markup.hpp"
#include "base/version.hpp"
#include "output/atomic_file.hpp"
#include "report/html_page.hpp"
#include "report/page_assets.hpp"
#include "report/report_data.hpp"
#include "report/report_json.hpp"
#include "report/summary_json.hpp"

namespace riffle::inline report {

namespace {

/// The analyses as a data block of the page.
std::string analyses_block(const std::vector<Analysis>& analyses) {
    return escape_json_for_script(analysis_to_json(analyses));
}

std::string make_html(const ReportData& data, const Analysis& analysis) {
    const PageAssets assets = page_assets();
    return fill_page(assets.report, {{"title", escape_markup(data.title)},
                                     {"generator", escape_markup("Riffle " + version())},
                                     {"style", std::string(assets.style)},
                                     {"data", escape_json_for_script(page_json(data, analysis))},
                                     {"analyses", analyses_block({analysis})},
                                     {"plotly", std::string(assets.plotly)},
                                     {"script", assets.report_script}});
}

}  // namespace

std::string report_html(const std::filesystem::path& results, const Analysis& analysis) {
    return make_html(collect_report_data(results, analysis), analysis);
}

std::string report_summary_json(const std::filesystem::path& results, const Analysis& analysis) {
    return summary_json(collect_report_data(results, analysis), analysis);
}

std::string comparison_html(const Comparison& comparison) {
    const PageAssets assets = page_assets();
    std::vector<Analysis> analyses;
    for (const ComparedRun& run : comparison.runs) analyses.push_back(run.analysis);
    return fill_page(assets.comparison, {{"title", escape_markup(comparison.title)},
                                         {"generator", escape_markup("Riffle " + version())},
                                         {"style", std::string(assets.style)},
                                         {"data", escape_json_for_script(comparison_page_json(comparison))},
                                         {"analyses", analyses_block(analyses)},
                                         {"plotly", std::string(assets.plotly)},
                                         {"script", assets.comparison_script}});
}

std::filesystem::path find_results_file(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        std::filesystem::path inside = path / "results.h5";
        if (std::filesystem::exists(inside, error)) return inside;
        throw FileError(path.string() +
                        ": no results.h5 in this folder; expected the folder that `riffle run -o` filled");
    }
    if (!std::filesystem::exists(path, error)) {
        throw FileError(path.string() +
                        ": no such file or folder; expected the folder of a run or its results.h5");
    }
    return path;
}

std::filesystem::path summary_beside(const std::filesystem::path& html) {
    // What is written to a device is looked at or thrown away: nothing is left beside it.
    std::error_code unknown;
    if (std::filesystem::exists(html, unknown) && !std::filesystem::is_regular_file(html, unknown)) return {};
    const std::string stem = html.stem().string();
    return html.parent_path() / (stem == "report" ? "summary.json" : stem + "-summary.json");
}

void write_report(const std::filesystem::path& results, const std::filesystem::path& html,
                  const std::filesystem::path& json, const Analysis& analysis) {
    const ReportData data = collect_report_data(results, analysis);
    write_text_atomically(html, make_html(data, analysis));
    if (!json.empty()) write_text_atomically(json, summary_json(data, analysis));
}

void write_comparison(const Comparison& comparison, const std::filesystem::path& html,
                      const std::filesystem::path& json) {
    write_text_atomically(html, comparison_html(comparison));
    if (!json.empty()) write_text_atomically(json, comparison_summary_json(comparison));
}

}  // namespace riffle::inline report
