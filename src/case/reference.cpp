#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "case/case_documents.hpp"
#include "case/conversion.hpp"
#include "case/key_table.hpp"
#include "case/presets.hpp"
#include "case/refusals.hpp"
#include "case/warnings.hpp"

namespace riffle::inline case_file {

namespace {

/// Text for a cell of a Markdown table; the documents that it names are links.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char letter : text) {
        if (letter == '|') escaped += '\\';
        escaped += letter;
    }
    static const std::regex document("docs/([a-z-]+)\\.md");
    return std::regex_replace(escaped, document, "[$1]($1.md)");
}

std::string type_text(const Key& key) {
    switch (key.type) {
        case ValueType::number: {
            const std::string_view name =
                key.dimension == Dimension::none ? "a number" : dimension_name(key.dimension);
            return std::string(name.substr(name.find(' ') + 1)) +  // without its article
                   (key.list ? " or list" : "");
        }
        case ValueType::integer:
            return "whole number";
        case ValueType::boolean:
            return "true, false";
        case ValueType::word:
            return "word";
        case ValueType::text:
            return "text";
        case ValueType::file:
            return "file";
    }
    return "";
}

std::string default_text(const Key& key) {
    if (key.required) return "required";
    return key.default_note.empty() ? fmt::format("`{}`", handy_value_text(key, key.get(Case{})))
                                    : key.default_note;
}

std::string meaning_text(const Key& key) {
    std::string text = key.meaning;
    for (const Word& option : key.words) {
        text += fmt::format("<br>`\"{}\"`: {}", option.name, option.meaning);
    }
    if (!key.unset_word.empty() && !key.unset_meaning.empty()) {
        text += fmt::format("<br>`\"{}\"`: {}", key.unset_word, key.unset_meaning);
    }
    if (!key.applies.id.empty()) {
        text +=
            fmt::format("<br>Used with `{}` = `{}`", key.applies.id, fmt::join(key.applies.words, "`, `"));
        if (!key.applies_also.id.empty()) {
            text += fmt::format(" and `{}` = `{}`", key.applies_also.id,
                                fmt::join(key.applies_also.words, "`, `"));
        }
        text += ".";
    }
    return cell(text);
}

std::string range_cell(const Key& key) {
    return range_text(key) + (key.range.reason.empty() ? "" : "<br>" + key.range.reason);
}

std::string section_page(const SectionKeys& section) {
    std::string page =
        section.name.empty() ? "\n## Heading\n\n" : fmt::format("\n## {}\n\n", section.heading());
    page += section.meaning +
            "\n\n| key | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n";
    for (const Key& key : section.keys) {
        page +=
            fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", key.name, type_text(key),
                        si_unit(key.dimension), default_text(key), cell(range_cell(key)), meaning_text(key));
    }
    return page;
}

std::string preset_page() {
    std::string page =
        "\n## Presets of [numerics]\n\n`preset` sets the defaults of the section; keys that the case gives win.\n\n| key |";
    std::string rule = "\n|---|";
    for (const Word& preset : Words<Preset>::list) {
        page += fmt::format(" {} |", preset.name);
        rule += "---|";
    }
    page += rule + "\n";
    for (const Key& key : find_section("numerics")->keys) {
        if (key.name == "preset") continue;
        page += fmt::format("| `{}` |", key.name);
        for (std::size_t i = 0; i < Words<Preset>::list.size(); ++i) {
            Case c;
            c.numerics = preset_numerics(static_cast<Preset>(i));
            page += fmt::format(" `{}` |", handy_value_text(key, key.get(c)));
        }
        page += "\n";
    }
    return page;
}

/// The options with their equations and where they are advised: one table per key that has words with advice.
std::string options_page() {
    std::string page =
        "\n## Options of the method\n\nWhere the equation of each choice stands, who stated it, and where to take it. Sections are those of the [theory](theory.md); numbers stand there and in [verification](verification.md), beside the commands that measure them. `riffle sweep CASE --vary KEY=WORD,WORD` compares choices in a case of your own ([how](sweep.md)).\n";
    for (const SectionKeys& section : key_table()) {
        for (const Key& key : section.keys) {
            if (std::all_of(key.words.begin(), key.words.end(),
                            [](const Word& option) { return option.advice.empty(); })) {
                continue;
            }
            page += fmt::format("\n### `{}`\n\n| choice | equation, source | advice |\n|---|---|---|\n",
                                key.id());
            for (const Word& option : key.words) {
                page += fmt::format("| `{}` | {} | {} |\n", option.name, cell(std::string(option.source)),
                                    cell(std::string(option.advice)));
            }
        }
    }
    return page;
}

/// Tables of checks, one per section of their first keys.
std::string check_tables(const std::vector<CaseCheck>& checks) {
    std::string page;
    for (const SectionKeys& section : key_table()) {
        std::string rows;
        for (const CaseCheck& check : checks) {
            if (find_key(check.keys.front())->section == section.name) {
                rows += fmt::format("| {} | {} |\n", cell(std::string(check.what)),
                                    cell(finding_text("", check, {})));
            }
        }
        if (!rows.empty()) {
            page += fmt::format("\n### {}\n\n| what | why, and what to do |\n|---|---|\n{}",
                                section.heading(), rows);
        }
    }
    return page;
}

std::string check_page() {
    std::vector<CaseCheck> refused = start_of_run_refusals().checks;
    for (const CheckList& list : refusals()) {
        refused.insert(refused.end(), list.checks.begin(), list.checks.end());
    }
    return "\n## What is refused\n\nBeyond the types, ranges and words of the tables above, and keys that go only with another one. The message names the place, the values and what to do. Keys without a section are those of the heading.\n" +
           check_tables(refused) +
           "\nWhat needs more than the case is looked at by the verb that has it: files of surfaces and of heights when the case is read (that a bed covers the channel, stands above its floor, repeats at periodic ends, and has no wide hole); at the start of a run the results file to start from, sampling frequencies above half of the inverse of the time step, and the memory that the run takes.\n\n## What is warned of\n\n`riffle check` and `riffle run` say where a case leaves what was verified ([why](theory.md#18-known-limits-and-the-verified-envelope)), and which keys have no effect.\n" +
           check_tables(warnings().checks);
}

std::string unit_page() {
    std::string page =
        "\n## Units\n\nA number without quotes is in the SI unit of its key. A text in quotes is a number and a unit: `\"50 mm\"`, `\"2.5cm\"`, `\"1e-6 m2/s\"`. Beyond the ranges of the keys themselves, quantities of a size that cannot be meant are refused: below the least one other than zero, of keys that take no negative numbers, and above the largest one, in SI units.\n\n| | units | least | largest | for |\n|---|---|---|---|---|\n";
    for (const Dimension dimension :
         {Dimension::length, Dimension::time, Dimension::velocity, Dimension::acceleration,
          Dimension::kinematic_viscosity, Dimension::density, Dimension::discharge, Dimension::frequency,
          Dimension::number_per_area, Dimension::area}) {
        const QuantityLimits limits = *quantity_limits(dimension);
        page += fmt::format("| {} | {} | {:g} | {:g} | {} |\n", dimension_name(dimension),
                            unit_list(dimension), limits.least, limits.most, limits.reason);
    }
    return page;
}

}  // namespace

std::string case_reference_markdown() {
    std::string page =
        "# Case file reference\n\n<!-- Made by `riffle schema --markdown -o docs/case-reference.md` from the key table in src/case. -->\n\nA case file is [TOML](https://toml.io) and defines a run completely. Every key has a default unless it says `required`. Axes: x down the bed, z normal to it and upward from the bed level z = 0.\n\nOptions of the command line change single keys: `--set channel.depth=\"60 mm\"`. `riffle new case.toml` writes a commented case, `riffle schema -o case.schema.json` a JSON schema with which an editor completes and checks case files, and `riffle check case.toml` says what a case will cost.\n";
    for (const SectionKeys& section : key_table()) page += section_page(section);
    return page + options_page() + preset_page() + unit_page() + check_page();
}

}  // namespace riffle::inline case_file
