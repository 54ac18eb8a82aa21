#pragma once

#include <filesystem>
#include <string_view>

namespace riffle::inline output {

/// Write a text file in one atomic step: at each instant `path` holds the whole old or the whole new text.
/// Throws FileError (missing folder, no permission, disk full ...); the old file is then untouched.
void write_text_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace riffle::inline output
