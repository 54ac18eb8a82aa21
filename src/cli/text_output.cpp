#include "cli/text_output.hpp"

#include <fmt/format.h>

#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"

namespace riffle {

void refuse_to_replace_any(const std::vector<std::string>& files, bool force) {
    for (const std::string& file : files) {
        if (!file.empty() && file != "-" && !force) {
            refuse_to_replace(file);
        }
    }
}

void write_text(const std::string& file, const std::string& text) {
    if (file == "-") {
        fmt::print("{}", text);
        return;
    }
    write_text_atomically(file, text);
}

}  // namespace riffle
