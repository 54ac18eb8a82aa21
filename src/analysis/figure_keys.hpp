#pragma once

#include <string_view>

namespace riffle::inline analysis {

/// Whether a chapter, or any of them where none is named, may make a figure of this key (docs/analysis.md).
/// So what an analysis will write is known before it is made.
[[nodiscard]] bool is_figure_key(std::string_view key, std::string_view chapter = {});

}  // namespace riffle::inline analysis
