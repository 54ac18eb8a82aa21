#pragma once

#include <string>
#include <vector>

namespace riffle::inline cli {

/// Refuse to replace files that exist, unless that is asked for, and to write two outputs to one place; empty
/// names are none, and "-" is the terminal. Throws InputError.
void refuse_to_replace_any(const std::vector<std::string>& files, bool force);

/// Write a text to a file in one step, or to the terminal where the name is "-".
void write_text(const std::string& file, const std::string& text);

}  // namespace riffle::inline cli
