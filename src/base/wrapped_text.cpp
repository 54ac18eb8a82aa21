#include "base/wrapped_text.hpp"

#include <algorithm>

namespace riffle::inline base {

std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string wrapped_text(std::string_view line, std::size_t indent, std::size_t columns) {
    std::string text;
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    std::string current(line.substr(0, begin));
    bool empty = true;  // the current line has no word yet
    for (std::size_t at = begin; at < line.size();) {
        const std::size_t space = line.find_first_not_of(' ', at);
        if (space == std::string_view::npos) break;
        const std::size_t end = std::min(line.find(' ', space), line.size());
        const std::string_view word = line.substr(space, end - space);
        const std::string_view with_spaces = line.substr(at, end - at);
        if (!empty && columns_of(current) + columns_of(with_spaces) > columns) {
            text += current + "\n";
            current = std::string(indent, ' ');
            current += word;
        } else {
            current += with_spaces;
        }
        empty = false;
        at = end;
    }
    return text + current;
}

}  // namespace riffle::inline base
