#include "cli/text_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"

namespace riffle::inline cli {

void refuse_to_replace_any(const std::vector<std::string>& files, bool force) {
    for (auto file = files.begin(); file != files.end(); ++file) {
        if (!file->empty() && std::find(file + 1, files.end(), *file) != files.end()) {
            throw InputError(
                fmt::format("two outputs would go to the same place, {}: give each its own", *file));
        }
    }
    for (const std::string& file : files) {
        if (!file.empty() && file != "-" && !force) refuse_to_replace(file);
    }
}

void write_text(const std::string& file, const std::string& text) {
    if (file == "-") {
        fmt::print("{}", text);
        return;
    }
    write_text_atomically(file, text);
}

}  // namespace riffle::inline cli
