#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/key.hpp"

namespace riffle {

/// A section of the case file and its keys, in the order in which they are read and written.
struct SectionKeys {
    std::string name;  ///< empty: the keys before the first section
    std::string meaning;
    std::vector<Key> keys;
};

/// All sections and keys of the case file.
[[nodiscard]] const std::vector<SectionKeys>& key_table();

/// The section of that name, or nullptr.
[[nodiscard]] const SectionKeys* find_section(std::string_view name);

/// The key of that name in a section, or nullptr.
[[nodiscard]] const Key* find_key(std::string_view section, std::string_view name);

/// The key "section.key", or nullptr.
[[nodiscard]] const Key* find_key(std::string_view id);

/// Whether the key has an effect in a case (its `applies` holds).
[[nodiscard]] bool key_applies(const Key& key, const Case& c);

}  // namespace riffle
