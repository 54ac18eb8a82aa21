#pragma once

#include <filesystem>
#include <string_view>

namespace riffle::inline output {

/// Throws InputError where the file exists: what a user has written is not replaced without --force.
void refuse_to_replace(const std::filesystem::path& file);

/// What a file begins with that holds a page, or JSON, as Riffle writes them.
inline constexpr std::string_view begin_of_page = "<!doctype html";
inline constexpr std::string_view begin_of_json = "{";

/// Throws InputError where `file` exists and does not begin with `begin` (blanks before it and the case of
/// its letters do not count): then it is not an older version of what is to be written, `what`, but something
/// else that would be lost. An empty file and a device may be written to.
void refuse_to_replace_another(const std::filesystem::path& file, std::string_view begin,
                               std::string_view what);

}  // namespace riffle::inline output
