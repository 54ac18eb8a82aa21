#pragma once

#include <string>
#include <string_view>

namespace riffle::inline base {

/// Text for XML or HTML: the characters & < > " replaced by their entities.
[[nodiscard]] std::string escape_markup(std::string_view text);

}  // namespace riffle::inline base
