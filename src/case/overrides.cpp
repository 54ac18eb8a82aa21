#include "case/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "case/key_table.hpp"
#include "case/unknown_names.hpp"

namespace riffle::inline case_file {

namespace {

/// What an option names: `numerics.spacing`, or `solid.pier.x`, with the name of one of several sections.
struct OptionName {
    std::string section;
    std::string item;  ///< empty without a name
    std::string key;
};

OptionName split_name(std::string_view text) {
    const auto first = text.find('.');
    if (first == std::string_view::npos) {
        return {"", "", std::string(text)};
    }
    const SectionKeys* const section = find_section(text.substr(0, first));
    // The name of a section may have dots itself.
    const auto last = section != nullptr && section->repeated() ? text.rfind('.') : first;
    const std::string_view item =
        last > first ? text.substr(first + 1, last - first - 1) : std::string_view();
    return {std::string(text.substr(0, first)), std::string(item), std::string(text.substr(last + 1))};
}

/// The sections of a kind that the document has.
std::size_t count_of(const Document& document, const std::string& section) {
    return static_cast<std::size_t>(std::count_if(
        document.sections.begin(), document.sections.end(),
        [&](const SectionMention& mention) { return mention.repeated && mention.name == section; }));
}

/// Those of them that have a name, with it.
std::vector<std::pair<std::size_t, std::string>> named_items(const Document& document,
                                                             const std::string& section) {
    std::vector<std::pair<std::size_t, std::string>> named;
    for (const Entry& entry : document.entries) {
        const auto* const name = std::get_if<std::string>(&entry.value);
        if (entry.repeated && entry.section == section && entry.key == "name" && name != nullptr) {
            named.emplace_back(entry.item, *name);
        }
    }
    return named;
}

/// Which of the sections of a kind has this name; none without one.
std::optional<std::size_t> item_of(const Document& document, const OptionName& option) {
    for (const auto& [item, name] : named_items(document, option.section)) {
        if (name == option.item) return item;
    }
    return std::nullopt;
}

std::string unknown_item(const Document& document, const OptionName& option) {
    const std::string& section = option.section;
    if (count_of(document, section) == 0) {
        return fmt::format("the case has no [[{}]]: options change those that it has, they add none",
                           section);
    }
    std::vector<std::string> names;
    for (const auto& named : named_items(document, section)) names.push_back("\"" + named.second + "\"");
    if (names.empty()) {
        return fmt::format("no [[{0}]] of the case has a name: give it one, then --set {0}.NAME.{1}=...",
                           section, option.key);
    }
    return fmt::format("{}: those of the case are {}; write {}.NAME.{}",
                       option.item.empty()
                           ? fmt::format("which [[{}]] is meant", section)
                           : fmt::format("no [[{}]] of the case is named \"{}\"", section, option.item),
                       fmt::join(names, ", "), section, option.key);
}

/// Replace or add one entry.
void apply(Document& document, const Override& option, const OptionName& name, std::size_t item,
           bool repeated, const Place& place) {
    std::erase_if(document.entries, [&](const Entry& entry) {
        return entry.section == name.section && entry.item == item && entry.key == name.key;
    });
    const Key* const key = find_key(name.section, name.key);
    const bool text = key != nullptr && (key->type == ValueType::text || key->type == ValueType::file);
    RawValue value = read_option_value(option.value);
    if (text && !std::holds_alternative<std::string>(value)) {
        value = read_option_text(option.value);  // a title such as 2026 needs no quotes on the command line
    }
    document.entries.push_back({name.section, name.key, std::move(value), place, place, item, repeated});
}

}  // namespace

void apply_overrides(Document& document, const std::vector<Override>& overrides, Problems& problems) {
    for (const Override& option : overrides) {
        const Place place{fmt::format("--set {}={}", option.key, option.value), 0, 0, true};
        const OptionName name = split_name(option.key);
        const SectionKeys* const section = find_section(name.section);
        if (section == nullptr) {
            problems.add(place, unknown_section(name.section));
        } else if (!section->repeated()) {
            apply(document, option, name, 0, false, place);
        } else if (const auto item = item_of(document, name)) {
            apply(document, option, name, *item, true, place);
        } else {
            problems.add(place, unknown_item(document, name));
        }
    }
}

KeyItem find_option_key(const Case& c, std::string_view text) {
    const OptionName name = split_name(text);
    const SectionKeys* const section = find_section(name.section);
    const Key* const key = find_key(name.section, name.key);
    if (section == nullptr || key == nullptr || !section->repeated()) {
        return {key, 0};
    }
    const Key* const names = find_key(name.section, "name");
    for (std::size_t item = 0; names != nullptr && item < section->count(c); ++item) {
        const Value value = names->get(c, item);
        const auto* const found = std::get_if<std::string>(&value);
        if (found != nullptr && *found == name.item) {
            return {key, item};
        }
    }
    return {};
}

}  // namespace riffle::inline case_file
