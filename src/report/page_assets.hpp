#pragma once

#include <string>
#include <string_view>

namespace riffle::inline report {

/// The parts of the report's pages, embedded in the binary from web/ (cmake/web.cmake).
struct PageAssets {
    std::string_view report;      ///< the page of one run, with {{name}} where the other parts go
    std::string_view comparison;  ///< the page of several runs
    std::string_view style;       ///< CSS
    std::string_view plotly;      ///< the figure library
    std::string report_script;    ///< scripts of the page of one run
    std::string comparison_script;
    std::string shared_script;      ///< what these scripts share, for further pages
    std::string_view field_script;  ///< the picture of the flow field
};

[[nodiscard]] PageAssets page_assets();

}  // namespace riffle::inline report
