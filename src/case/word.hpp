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

namespace detail {

/// Whether a value of an enumeration has a name: compilers write those that have none as "(Type)5".
template <auto value>
[[nodiscard]] constexpr bool is_enumerator() {
    return std::string_view(__PRETTY_FUNCTION__).find("value = (") == std::string_view::npos;
}

/// How many enumerators there are from 0 on.
template <class Enum, std::size_t count = 0>
[[nodiscard]] constexpr std::size_t enumerators() {
    if constexpr (is_enumerator<static_cast<Enum>(count)>()) {
        return enumerators<Enum, count + 1>();
    } else {
        return count;
    }
}

template <class Enum>
[[nodiscard]] constexpr bool each_has_a_word() {
    const auto& list = Words<Enum>::list;
    if (list.size() != enumerators<Enum>()) return false;
    for (const Word& each : list) {
        if (each.name.empty()) return false;
    }
    return true;
}

}  // namespace detail

/// The word of the case file for an option.
template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] constexpr std::string_view word(Enum option) {
    static_assert(detail::each_has_a_word<Enum>(), "Words<Enum>::list has one word for each enumerator");
    return Words<Enum>::list[static_cast<std::size_t>(option)].name;
}

}  // namespace riffle::inline case_file
