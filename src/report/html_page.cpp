#include "report/html_page.hpp"

#include <stdexcept>

namespace riffle::inline report {

std::string escape_json_for_script(std::string_view json) {
    std::string result;
    result.reserve(json.size());
    for (const char c : json) {
        if (c == '<') {
            result += "\\u003c";
        } else {
            result += c;
        }
    }
    return result;
}

std::string fill_page(std::string_view page, const std::map<std::string, std::string, std::less<>>& parts) {
    std::string result;
    while (true) {
        const std::size_t open = page.find("{{");
        if (open == std::string_view::npos) return result.append(page);
        const std::size_t close = page.find("}}", open);
        const std::string_view name =
            page.substr(open + 2, close == std::string_view::npos ? close : close - open - 2);
        const auto part = parts.find(name);
        if (close == std::string_view::npos || part == parts.end()) {
            throw std::logic_error("report page: no part for {{" + std::string(name) + "}}");
        }
        result.append(page.substr(0, open)).append(part->second);
        page.remove_prefix(close + 2);
    }
}

}  // namespace riffle::inline report
