#include "case/problems.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/error.hpp"

namespace riffle::inline case_file {

void Problems::add(Place place, std::string message) {
    list_.push_back({std::move(place), std::move(message)});
}

void Problems::raise() const {
    std::vector<Problem> sorted = list_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
        return std::tie(a.place.option, a.place.line, a.place.column) <
               std::tie(b.place.option, b.place.line, b.place.column);
    });
    constexpr std::size_t most = 40;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i) {
        text += text.empty() ? "" : "\n";
        text += sorted[i].place.text() + ": " + sorted[i].message;
    }
    if (sorted.size() > most) text += "\nand " + std::to_string(sorted.size() - most) + " more of the kind";
    throw InputError(text);
}

const Place& Places::of_first(const std::vector<std::string>& ids) const {
    const auto found = std::find_if(ids.begin(), ids.end(), [&](const auto& id) { return given(id); });
    return found == ids.end() ? whole_ : of(*found);
}

}  // namespace riffle::inline case_file
