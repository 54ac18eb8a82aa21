#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace riffle::inline base {

/// Columns that a terminal is sure to have.
inline constexpr std::size_t usual_columns = 80;

/// Columns that a text in UTF-8 takes: its characters.
[[nodiscard]] std::size_t columns_of(std::string_view text);

/// A line broken at its spaces into lines of at most `columns`, without a newline at the end; those after the
/// first begin with `indent` spaces. A word that is longer stands on a line of its own. Spaces within lines
/// stay as they are.
[[nodiscard]] std::string wrapped_text(std::string_view line, std::size_t indent,
                                       std::size_t columns = usual_columns);

}  // namespace riffle::inline base
