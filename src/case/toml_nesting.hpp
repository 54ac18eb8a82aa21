#pragma once

#include <string>

namespace riffle::inline case_file {

/// Parts that a dotted key may have, and arrays and tables that may stand in each other. A case needs two of
/// either; the TOML library works through both by recursion, and some ten thousand overflow the stack.
inline constexpr int most_key_parts = 16;
inline constexpr int deepest_nesting = 16;

/// Refuse TOML text that is nested deeper, before it is parsed; `name` stands for the file. Throws InputError
/// with line and column.
void refuse_deep_nesting(const std::string& text, const std::string& name);

}  // namespace riffle::inline case_file
