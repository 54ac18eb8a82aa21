#include "report/case_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include "case/conversion.hpp"
#include "case/flow_conditions.hpp"
#include "case/key_table.hpp"

namespace riffle::inline report {

namespace {

/// Sections that do not define the flow that is simulated, but for the surface that its measurements take.
constexpr std::array<std::string_view, 3> aside = {"", "measured", "output"};
constexpr std::array<std::string_view, 2> measured_surface = {"output.surface_detection",
                                                              "output.surface_threshold"};

std::string shown_value(const Key& key, const Case& c) {
    std::string text = handy_value_text(key, key.get(c));
    text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
    return text;
}

std::string words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

bool all_distinct(const std::vector<std::string>& names) {
    return std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

/// What comes first in the name of a case: its flow condition, its title.
std::string base_name(const Case& c) {
    if (const auto number = flow_condition_of(c)) return fmt::format("condition {}", *number);
    return c.title.empty() ? "a flow without title" : c.title;
}

/// Names of cases of one base from their differences: the first key that alone tells them apart, else the
/// first two keys that do so together; empty where that takes more.
std::vector<std::string> parts_of(const std::vector<const Case*>& group) {
    const std::vector<CaseDifference> differences = case_differences(group);
    const auto part = [](const CaseDifference& difference, std::size_t i) {
        return difference.label + " " + difference.values[i];
    };
    std::vector<std::string> names(group.size());
    const auto in_space = std::find_if(differences.begin(), differences.end(), [](const CaseDifference& d) {
        return d.key == "channel.dimensions" && all_distinct(d.values);
    });
    if (in_space != differences.end()) {
        for (std::size_t i = 0; i < group.size(); ++i) names[i] = in_space->values[i] + "D";
        return names;
    }
    const auto alone = std::find_if(differences.begin(), differences.end(),
                                    [](const CaseDifference& d) { return all_distinct(d.values); });
    if (alone != differences.end()) {
        for (std::size_t i = 0; i < group.size(); ++i) names[i] = part(*alone, i);
        return names;
    }
    for (std::size_t first = 0; first < differences.size(); ++first) {
        for (std::size_t second = first + 1; second < differences.size(); ++second) {
            for (std::size_t i = 0; i < group.size(); ++i) {
                names[i] = part(differences[first], i) + ", " + part(differences[second], i);
            }
            if (all_distinct(names)) return names;
        }
    }
    return std::vector<std::string>(group.size());
}

}  // namespace

std::vector<CaseDifference> case_differences(const std::vector<const Case*>& cases) {
    std::vector<CaseDifference> differences;
    for (const SectionKeys& section : key_table()) {
        const bool is_aside = std::find(aside.begin(), aside.end(), section.name) != aside.end();
        for (const Key& key : section.keys) {
            if (is_aside && std::find(measured_surface.begin(), measured_surface.end(), key.id()) ==
                                measured_surface.end()) {
                continue;
            }
            CaseDifference difference{key.id(), words(key.name), {}};
            for (const Case* c : cases) {
                // A list of none, of solids say, is no value either.
                std::string value = key_applies(key, *c) ? shown_value(key, *c) : std::string();
                difference.values.push_back(value.empty() || value == "[]" ? "–" : std::move(value));
            }
            const auto& values = difference.values;
            const bool same = std::all_of(values.begin(), values.end(),
                                          [&](const std::string& value) { return value == values.front(); });
            if (!same) differences.push_back(std::move(difference));
        }
    }
    return differences;
}

std::vector<std::string> names_of_cases(const std::vector<const Case*>& cases,
                                        const std::vector<std::string>& otherwise) {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < cases.size(); ++i) groups[base_name(*cases[i])].push_back(i);
    std::vector<std::string> names(cases.size());
    for (const auto& [base, members] : groups) {
        std::vector<const Case*> group;
        group.reserve(members.size());
        for (const std::size_t member : members) group.push_back(cases[member]);
        const std::vector<std::string> parts = parts_of(group);
        for (std::size_t i = 0; i < members.size(); ++i) {
            const bool only_base = groups.size() == 1 && !parts[i].empty();
            names[members[i]] = only_base ? parts[i] : parts[i].empty() ? base : base + ", " + parts[i];
        }
    }
    return told_apart(names, otherwise);
}

std::vector<std::string> told_apart(const std::vector<std::string>& names,
                                    const std::vector<std::string>& otherwise) {
    std::vector<std::string> result = names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::count(names.begin(), names.end(), names[i]) > 1) result[i] += " (" + otherwise[i] + ")";
    }
    // The same thing given twice is numbered.
    const std::vector<std::string> added = result;
    for (std::size_t i = 0; i < added.size(); ++i) {
        const auto here = added.begin() + static_cast<std::ptrdiff_t>(i);
        const auto before = std::count(added.begin(), here, added[i]);
        if (before > 0) result[i] += fmt::format(" ({})", before + 1);
    }
    return result;
}

}  // namespace riffle::inline report
