#pragma once

#include <string>
#include <variant>

#include "case/key.hpp"
#include "case/toml_entries.hpp"

namespace riffle::inline case_file {

/// Most values of a list. The checks of an outline compare each of its edges with each other one.
inline constexpr std::size_t longest_list = 10000;

/// The value of a key, or why it is none (what was expected and what to do).
[[nodiscard]] std::variant<Value, std::string> convert(const Key& key, const RawValue& raw);

/// What a key takes, for messages: "a length greater than 0 m".
[[nodiscard]] std::string expectation(const Key& key);

/// The allowed range in words, empty without one: "greater than 0 m and at most 1 m".
[[nodiscard]] std::string range_text(const Key& key);

/// A value as a case file shows it: 0.05, "free-surface", "auto", true.
[[nodiscard]] std::string value_text(const Key& key, const Value& value);

/// The same for people, with handy units: "50 mm" (reads back as the same value).
[[nodiscard]] std::string handy_value_text(const Key& key, const Value& value);

/// Name for messages: "[channel] slope", "[[probe]] name".
[[nodiscard]] std::string shown_name(const Key& key);

}  // namespace riffle::inline case_file
