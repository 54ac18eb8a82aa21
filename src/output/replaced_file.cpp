#include "output/replaced_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

#include "base/error.hpp"

namespace riffle::inline output {

namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

void refuse_to_replace(const std::filesystem::path& file) {
    if (std::filesystem::exists(file)) {
        throw InputError(fmt::format(
            "{}: the file exists already; give another name, or --force to overwrite it", file.string()));
    }
}

void refuse_to_replace_another(const std::filesystem::path& file, std::string_view begin,
                               std::string_view what) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return;
    std::ifstream content(file, std::ios::binary);
    content >> std::ws;
    std::string found(begin.size(), '\0');
    content.read(found.data(), static_cast<std::streamsize>(found.size()));
    found.resize(static_cast<std::size_t>(content.gcount()));
    const bool another =
        !found.empty() && !std::equal(found.begin(), found.end(), begin.begin(), begin.end(), same_letter);
    if (another) {
        throw InputError(fmt::format(
            "{}: the file exists and is no {}; it would be lost. Give another name, or remove it first",
            file.string(), what));
    }
}

}  // namespace riffle::inline output
