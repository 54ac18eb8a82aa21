#include <string_view>

#include "analysis/analysis_json.hpp"
#include "base/markup.hpp"
#include "base/version.hpp"
#include "output/atomic_file.hpp"
#include "report/html_page.hpp"
#include "report/json_parts.hpp"
#include "report/page_assets.hpp"
#include "sweep/study_files.hpp"

// Ends of the embedded files, defined by the assembler listing that cmake/web.cmake writes.
extern "C" {
extern const char riffle_sweep_html_begin[];
extern const char riffle_sweep_html_end[];
extern const char riffle_sweep_script_begin[];
extern const char riffle_sweep_script_end[];
}

namespace riffle::inline sweep {

std::string sweep_page(const SweepStudy& sweep) {
    const PageAssets assets = page_assets();
    Json data = Json::parse(sweep_json(sweep));
    data["categories"] = figure_categories(sweep);
    const std::string analyses = analysis_to_json({sweep_figures(sweep)});
    const std::string script =
        assets.shared_script + std::string(riffle_sweep_script_begin, riffle_sweep_script_end);
    return fill_page({riffle_sweep_html_begin, riffle_sweep_html_end},
                     {{"title", escape_markup(sweep.title)},
                      {"generator", escape_markup("Riffle " + version())},
                      {"style", std::string(assets.style)},
                      {"data", escape_json_for_script(json_text(data, -1))},
                      {"analyses", escape_json_for_script(analyses)},
                      {"plotly", std::string(assets.plotly)},
                      {"script", script}});
}

void write_sweep(const SweepStudy& sweep, const SweepFiles& files) {
    write_text_atomically(files.csv(), sweep_csv(sweep));
    write_text_atomically(files.json(), sweep_json(sweep));
    write_text_atomically(files.page(), sweep_page(sweep));
}

}  // namespace riffle::inline sweep
