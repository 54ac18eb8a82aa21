#include "case/nearest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace riffle::inline case_file {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
        before_last.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

std::optional<std::string> nearest_name(std::string_view text, std::span<const std::string> known) {
    constexpr std::size_t longest_name = 100;
    if (text.size() > longest_name) {
        return std::nullopt;  // like no name, and the comparison would take its square of time
    }
    std::string asked(text);
    std::transform(asked.begin(), asked.end(), asked.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    const std::size_t limit = std::max<std::size_t>(2, asked.size() / 3);
    std::optional<std::string> best;
    std::size_t best_distance = limit + 1;
    for (const std::string& name : known) {
        const std::size_t distance = edit_distance(asked, name);
        // As many changes as letters is no likeness.
        if (distance < best_distance && distance < std::min(asked.size(), name.size())) {
            best = name;
            best_distance = distance;
        }
    }
    if (best) return best;
    constexpr std::size_t shortest_part = 4;
    for (const std::string& name : known) {
        const std::string& part = asked.size() < name.size() ? asked : name;
        const std::string& whole = asked.size() < name.size() ? name : asked;
        if (part.size() >= shortest_part && whole.find(part) != std::string::npos) return name;
    }
    return std::nullopt;
}

}  // namespace riffle::inline case_file
