#include "output/atomic_file.hpp"

#include <fmt/format.h>

#include <array>
#include <span>

#include "base/error.hpp"
#include "output/file_replace.hpp"

namespace riffle::inline output {

void write_text_atomically(const std::filesystem::path& path, std::string_view text) {
    const std::array parts = {std::as_bytes(std::span(text))};
    try {
        replace_file(path, parts);
    } catch (const std::system_error& error) {
        const bool existed = std::filesystem::exists(std::filesystem::symlink_status(path)) &&
                             !std::filesystem::is_directory(path);
        throw FileError(fmt::format("{}: cannot be written: {}{}", path.string(),
                                    explain(error.code(), path, text.size()),
                                    existed ? " The earlier file is untouched." : ""));
    }
}

}  // namespace riffle::inline output
