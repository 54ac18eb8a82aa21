#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace riffle::inline base {

/// Where a text holds a character that a terminal, a log or a page would obey instead of showing it, and
/// which: control characters (U+0000 to U+001F, U+007F to U+009F), the marks that turn the direction of
/// writing (U+061C, U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069), and bytes that are no UTF-8.
struct HiddenCharacter {
    std::size_t place = 0;   ///< byte in the text, from 0
    std::size_t length = 0;  ///< bytes
    std::string name;        ///< "U+001B", or "the byte 0xff" where it is no UTF-8
};

/// The first one from a byte on; those of `allowed` are none.
[[nodiscard]] std::optional<HiddenCharacter> hidden_character(std::string_view text, std::size_t from = 0,
                                                              std::string_view allowed = "");

/// A text from elsewhere (a file name, a key that nobody knows) for a message: its hidden characters as
/// <U+001B>, but for those of `allowed`.
[[nodiscard]] std::string visible_text(std::string_view text, std::string_view allowed = "");

/// A text of a file as a message shows it: its begin, where it is long.
[[nodiscard]] std::string shortened(const std::string& text);

}  // namespace riffle::inline base
