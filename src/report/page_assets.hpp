#pragma once

#include <string_view>

namespace riffle {

/// The parts of the report's page, embedded in the binary from web/ (cmake/web.cmake).
struct PageAssets {
    std::string_view html;    ///< the page with {{name}} where the other parts go
    std::string_view style;   ///< CSS
    std::string_view plotly;  ///< the figure library
    std::string_view script;  ///< the page's own first script: figures
    std::string_view field;   ///< second: picture of the flow field
    std::string_view page;    ///< third: puts the page together
};

[[nodiscard]] PageAssets page_assets();

}  // namespace riffle
