#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "case/bed_traits.hpp"
#include "case/case_documents.hpp"
#include "case/conversion.hpp"
#include "case/key_table.hpp"
#include "case/presets.hpp"
#include "case/quiet_water.hpp"

namespace riffle::inline case_file {

namespace {

constexpr std::size_t line_width = 100;

/// A comment, broken at blanks.
std::string comment(const std::string& text, const std::string& indent = "") {
    std::istringstream words(text);
    std::string lines;
    std::string line;
    for (std::string next; words >> next;) {
        if (!line.empty() && indent.size() + line.size() + next.size() + 3 > line_width) {
            lines += fmt::format("# {}{}\n", indent, line);
            line.clear();
        }
        line += line.empty() ? "" : " ";
        line += next;
    }
    return fmt::format("{}# {}{}\n", lines, indent, line);
}

std::string without_ticks(std::string text) {
    std::erase(text, '`');
    return text;
}

std::string key_comment(const Key& key) {
    std::vector<std::string> rules;
    if (key.required) rules.emplace_back("required");
    if (!si_unit(key.dimension).empty()) {
        rules.push_back(fmt::format("in {}", si_unit(key.dimension)));
    }
    if (const std::string range = range_text(key); !range.empty()) rules.push_back(range);
    std::string about = without_ticks(key.meaning);
    if (!rules.empty()) {
        about += fmt::format(" [{}]", fmt::join(rules, ", "));
    }
    std::string text = comment(about);
    for (const Word& option : key.words) {
        text += comment(fmt::format("\"{}\": {}", option.name, option.meaning), "  ");
    }
    if (!key.unset_meaning.empty()) {
        text += comment(fmt::format("\"{}\": {}", key.unset_word, without_ticks(key.unset_meaning)), "  ");
    }
    return text;
}

/// What follows for water beside inclined faces in a file that gives the lattice of the case where it is
/// another one.
void choose_for_quiet_water_of_file(Case& chosen) {
    const StartLattice lattice = chosen.start.lattice;
    chosen.start.lattice = Start{}.lattice;
    chosen.start.settling_time = Start{}.settling_time;
    Case by_default = chosen;
    choose_for_quiet_water(by_default, {});
    const bool given = by_default.start.lattice != lattice;
    chosen.start.lattice = lattice;
    choose_for_quiet_water(chosen, {.lattice = given});
    chosen.start.lattice = by_default.start.lattice;
}

/// The case that a file with nothing but the preset and the kind of bed would give.
Case defaults_of(const Case& c) {
    Case chosen = c;
    chosen.numerics = preset_numerics(c.numerics.preset, c.channel.dimensions);
    choose_resolution(chosen, {});
    choose_for_quiet_water_of_file(chosen);
    // The walls are as deep as the kernel that the file will say.
    Case wide = chosen;
    wide.numerics.smoothing_ratio = c.numerics.smoothing_ratio;
    choose_resolution(wide, {.spacing = true, .smoothing_ratio = true});
    chosen.numerics.wall_layers = wide.numerics.wall_layers;
    Case defaults;
    defaults.numerics = chosen.numerics;
    defaults.start.lattice = chosen.start.lattice;
    defaults.start.settling_time = chosen.start.settling_time;
    defaults.bed.kind = c.bed.kind;
    if (!has_spheres(c.bed)) defaults.bed.datum_below_crest = 0.0;
    return defaults;
}

/// When a key applies: `kind = "wave"`, of a key in another section with that section's name.
std::string condition_text(const Key& key) {
    const auto text_of = [&](const Applies& applies) {
        const Key& other = *find_key(applies.id);
        const std::string name = other.section == key.section ? other.name : applies.id;
        return other.type == ValueType::integer
                   ? fmt::format("{} = {}", name, fmt::join(applies.words, " or "))
                   : fmt::format("{} = \"{}\"", name, fmt::join(applies.words, "\" or \""));
    };
    return text_of(key.applies) + (key.applies_also.id.empty() ? "" : " and " + text_of(key.applies_also));
}

/// The keys of a section that a case may not give now, with what they take.
std::string further_keys(const SectionKeys& section, const Case& c) {
    std::map<std::string, std::vector<std::string>> keys;
    for (const Key& key : section.keys) {
        if (key.applies.strictly && !key_applies(key, c)) keys[condition_text(key)].push_back(key.name);
    }
    std::string text;
    for (const auto& [condition, names] : keys) {
        text += comment(fmt::format("With {} also: {}.", condition, fmt::join(names, ", ")));
    }
    return text;
}

/// What a repeated section looks like, all of it as comments.
std::string section_example(const SectionKeys& section) {
    std::string text =
        "\n" + comment(section.meaning + " What one may hold:") + fmt::format("#   {}\n", section.heading());
    for (const Key& key : section.keys) {
        std::istringstream about(key_comment(key));
        for (std::string line; std::getline(about, line);) text += "#   " + line + "\n";
        if (!key.applies.id.empty()) {
            text += comment(fmt::format("only with {}", condition_text(key)), "  # ");
        }
        text += fmt::format("#   {} = {}\n", key.name,
                            key.example.empty() ? handy_value_text(key, key.get(Case{})) : key.example);
    }
    return text;
}

/// The sections of a repeated kind that a case has.
std::string section_items(const SectionKeys& section, const Case& c) {
    std::string text;
    for (std::size_t item = 0; item < section.count(c); ++item) {
        text += fmt::format("\n{}\n", section.heading());
        for (const Key& key : section.keys) {
            const Value value = key.get(c, item);
            if (!(key.applies.strictly && !key_applies(key, c, item))) {
                text += fmt::format("{}{} = {}\n", key.required || value != key.get(Case{}) ? "" : "#",
                                    key.name, handy_value_text(key, value));
            }
        }
    }
    return text;
}

}  // namespace

std::string case_template(const Case& c) {
    const Case defaults = defaults_of(c);
    const Case plain;
    std::string text =
        "# A case of Riffle. Lines with `#key = value` show defaults: remove the # to change them.\n"
        "# Numbers are SI; a text in quotes may carry a unit: \"50 mm\", \"0.3 m/s\", \"2 min\".\n\n";
    for (const SectionKeys& section : key_table()) {
        if (section.repeated()) {
            text += section_example(section) + section_items(section, c);
            continue;
        }
        if (!section.name.empty()) {
            text += fmt::format("\n{}\n", section.heading()) + comment(without_ticks(section.meaning)) + "\n";
        }
        for (const Key& key : section.keys) {
            if (key.applies.strictly && !key_applies(key, c)) continue;
            const Value value = key.get(c);
            // Preset and kind of bed are defaults of `defaults`, not of the file.
            const bool differs =
                value != key.get(defaults) ||
                ((key.id() == "numerics.preset" || key.id() == "bed.kind") && value != key.get(plain));
            text += key_comment(key);
            text += fmt::format("{}{} = {}\n", key.required || differs ? "" : "#", key.name,
                                handy_value_text(key, value));
        }
        text += further_keys(section, c);
    }
    return text;
}

}  // namespace riffle::inline case_file
