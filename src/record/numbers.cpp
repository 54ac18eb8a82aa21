#include "record/numbers.hpp"

#include <algorithm>
#include <cmath>

#include "base/not_a_number.hpp"

namespace riffle::inline record {

std::optional<double> Numbers::find(const Field& field) const {
    const auto found = std::find_if(all_.begin(), all_.end(),
                                    [&](const auto& number) { return number.first == field.name; });
    return found == all_.end() ? std::nullopt : std::optional(found->second);
}

double Numbers::value(const std::string& name) const {
    const auto found =
        std::find_if(all_.begin(), all_.end(), [&](const auto& number) { return number.first == name; });
    return found == all_.end() ? not_a_number : found->second;
}

void Numbers::set(const std::string& name, double value) {
    for (auto& [key, old] : all_) {
        if (key == name) {
            old = value;
            return;
        }
    }
    all_.emplace_back(name, value);
}

std::optional<double> find_value(const Numbers& numbers, const Field& field) {
    const std::optional<double> value = numbers.find(field);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace riffle::inline record
