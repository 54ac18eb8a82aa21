#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>

namespace riffle::inline case_file {

/// A word of the case file that names an option, and what the option is.
struct Word {
    std::string_view name;
    std::string_view meaning;
    std::string_view source = {};  ///< the equation and who stated it
    std::string_view advice = {};  ///< where to take it and where not; what was measured stands in docs/
};

/// The words of an enumeration, in the order of its enumerators.
template <class Enum>
struct Words;

/// The word of the case file for an option.
template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] constexpr std::string_view word(Enum option) {
    return Words<Enum>::list[static_cast<std::size_t>(option)].name;
}

}  // namespace riffle::inline case_file
