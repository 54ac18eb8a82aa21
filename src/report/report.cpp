#include "report/report.hpp"

#include <string>
#include <system_error>

#include "base/error.hpp"
#include "base/markup.hpp"
#include "base/version.hpp"
#include "output/atomic_file.hpp"
#include "report/html_page.hpp"
#include "report/page_assets.hpp"
#include "report/report_data.hpp"
#include "report/report_json.hpp"

namespace riffle {

namespace {

std::string make_html(const ReportData& data) {
    const PageAssets assets = page_assets();
    std::string script(assets.script);
    script.append("\n").append(assets.field).append("\n").append(assets.page);
    return fill_page(assets.html, {{"title", escape_markup(data.title)},
                                   {"generator", escape_markup("Riffle " + version())},
                                   {"style", std::string(assets.style)},
                                   {"data", escape_json_for_script(page_json(data))},
                                   {"plotly", std::string(assets.plotly)},
                                   {"script", script}});
}

}  // namespace

std::string report_html(const std::filesystem::path& results) {
    return make_html(collect_report_data(results));
}

std::string report_summary_json(const std::filesystem::path& results) {
    return summary_json(collect_report_data(results));
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

void write_report(const std::filesystem::path& results, const std::filesystem::path& html,
                  const std::filesystem::path& json) {
    const ReportData data = collect_report_data(results);
    write_text_atomically(html, make_html(data));
    if (!json.empty()) write_text_atomically(json, summary_json(data));
}

}  // namespace riffle
