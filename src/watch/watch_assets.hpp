#pragma once

#include <string_view>

namespace riffle::inline watch {

/// The parts of the watch page, embedded in the binary from web/ (cmake/web.cmake). Style and figure library
/// are those embedded for the report (report/page_assets.hpp).
struct WatchAssets {
    std::string_view html;    ///< the page
    std::string_view style;   ///< CSS beside the report's
    std::string_view script;  ///< follows the run
};

[[nodiscard]] WatchAssets watch_assets();

}  // namespace riffle::inline watch
