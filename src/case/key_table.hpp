#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/key.hpp"

namespace riffle::inline case_file {

/// A section of the case file and its keys, in the order in which they are read and written.
struct SectionKeys {
    std::string name;  ///< empty: the keys before the first section
    std::string meaning;
    std::vector<Key> keys;
    /// For a section that may stand several times, [[name]]: how often a case has it. Empty for the others.
    std::function<std::size_t(const Case&)> items = {};

    [[nodiscard]] bool repeated() const { return static_cast<bool>(items); }
    /// How often a case has the section.
    [[nodiscard]] std::size_t count(const Case& c) const { return repeated() ? items(c) : 1; }
    /// Its line in a case file: "[channel]", "[[probe]]"; empty before the first section.
    [[nodiscard]] std::string heading() const;
};

/// All sections and keys of the case file.
[[nodiscard]] const std::vector<SectionKeys>& key_table();

/// The section of that name, or nullptr.
[[nodiscard]] const SectionKeys* find_section(std::string_view name);

/// The key of that name in a section, or nullptr.
[[nodiscard]] const Key* find_key(std::string_view section, std::string_view name);

/// The key "section.key", or nullptr.
[[nodiscard]] const Key* find_key(std::string_view id);

/// The first condition of a key that does not hold in a case, in a repeated section in that `item`; nullptr
/// where all do.
[[nodiscard]] const Applies* unmet_condition(const Key& key, const Case& c, std::size_t item = 0);

/// Whether the key has an effect in a case (its `applies` holds), in a repeated section in that `item`.
[[nodiscard]] bool key_applies(const Key& key, const Case& c, std::size_t item = 0);

}  // namespace riffle::inline case_file
