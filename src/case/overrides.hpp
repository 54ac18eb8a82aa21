#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "case/key.hpp"
#include "case/problems.hpp"
#include "case/toml_entries.hpp"

namespace riffle::inline case_file {

/// Replace or add the entries of a case that options give: `section.key=value`, and of a section that may
/// stand several times `section.name.key=value`, by the name that it has in the case. Options apply in their
/// order.
void apply_overrides(Document& document, const std::vector<Override>& overrides, Problems& problems);

/// A key, and in which of the sections of its name.
struct KeyItem {
    const Key* key = nullptr;
    std::size_t item = 0;
};

/// The key of a case that an option names so; its key is null where there is none.
[[nodiscard]] KeyItem find_option_key(const Case& c, std::string_view name);

}  // namespace riffle::inline case_file
