#include "case/toml_entries.hpp"

#include <fmt/format.h>
// The only file that knows the TOML library: it is slow to compile.
#include <toml++/toml.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include "base/error.hpp"
#include "case/toml_nesting.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

Place place_of(const toml::source_region& source, const std::string& name) {
    return {name, source.begin.line, source.begin.column, false};
}

RawScalar raw_scalar(const toml::node& node) {
    if (const auto boolean = node.as_boolean()) return boolean->get();
    if (const auto integer = node.as_integer()) return static_cast<long long>(integer->get());
    if (const auto number = node.as_floating_point()) return number->get();
    if (const auto text = node.as_string()) return text->get();
    if (node.is_table()) {
        return OtherValue{"a table"};
    }
    if (node.is_array()) {
        return OtherValue{"an array"};
    }
    return OtherValue{"a date or time"};
}

RawValue raw_value(const toml::node& node) {
    if (const toml::array* const array = node.as_array()) {
        RawList list;
        for (const toml::node& item : *array) list.items.push_back(raw_scalar(item));
        return list;
    }
    return std::visit([](const auto& scalar) { return RawValue(scalar); }, raw_scalar(node));
}

std::string line_of(const std::string& text, unsigned line) {
    std::size_t begin = 0;
    for (unsigned i = 1; i < line && begin != std::string::npos; ++i) {
        begin = text.find('\n', begin);
        begin += begin == std::string::npos ? 0 : 1;
    }
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find('\n', begin) - begin);
}

/// What to do about a syntax error, for the mistakes that happen most.
std::string advice(std::string_view description, const std::string& line) {
    if (description.find("redefine") != std::string_view::npos) {
        return "each section and each key of a section may stand only once: remove one";
    }
    const auto equals = line.find('=');
    if (equals != std::string::npos) {
        std::string value = line.substr(equals + 1);
        value = value.substr(0, value.find('#'));
        const auto last = value.find_last_not_of(" \t\r");
        const auto quantity = split_quantity(value.substr(0, last == std::string::npos ? 0 : last + 1));
        if (quantity && !quantity->unit.empty()) {
            return fmt::format("a value with a unit stands in quotes: \"{} {}\"", quantity->value,
                               quantity->unit);
        }
        const auto first = value.find_first_not_of(" \t");
        if (first != std::string::npos && std::isalpha(static_cast<unsigned char>(value[first])) != 0) {
            return "a word stands in quotes: kind = \"spheres\"";
        }
    }
    return "a line is `key = value`, `[section]` or `# comment`";
}

/// A number that TOML does not write so (".5", "5."), for the command line.
std::optional<double> bare_number(const std::string& text) {
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = status == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string Place::text() const { return line == 0 ? name : fmt::format("{}:{}:{}", name, line, column); }

Document read_toml(const std::string& text, const std::string& name) {
    refuse_deep_nesting(text, name);
    toml::table root;
    try {
        root = toml::parse(text);
    } catch (const toml::parse_error& error) {
        const Place place = place_of(error.source(), name);
        throw InputError(fmt::format("{}: not TOML: {}; {}", place.text(), error.description(),
                                     advice(error.description(), line_of(text, place.line))));
    }
    Document document;
    const auto add_section = [&](SectionMention section, const toml::table& table) {
        for (const auto& [key, node] : table) {
            document.entries.push_back({section.name, std::string(key.str()), raw_value(node),
                                        place_of(key.source(), name), place_of(node.source(), name),
                                        section.item, section.repeated});
        }
        document.sections.push_back(std::move(section));
    };
    for (const auto& [key, node] : root) {
        const std::string key_text(key.str());
        const toml::array* const array = node.as_array();
        if (array != nullptr && array->is_array_of_tables()) {
            std::size_t item = 0;
            for (const toml::node& part : *array) {
                add_section({key_text, place_of(part.source(), name), item++, true}, *part.as_table());
            }
            continue;
        }
        const toml::table* const table = node.as_table();
        if (table == nullptr) {
            document.entries.push_back(
                {"", key_text, raw_value(node), place_of(key.source(), name), place_of(node.source(), name)});
            continue;
        }
        add_section({key_text, place_of(key.source(), name)}, *table);
    }
    return document;
}

RawValue read_option_text(const std::string& text) {
    try {
        (void)toml::parse("value = " + toml_string(text));
    } catch (const toml::parse_error&) {
        return OtherValue{"a text that is not UTF-8"};  // would make the case unreadable
    }
    return text;
}

RawValue read_option_value(const std::string& text) {
    try {
        refuse_deep_nesting(text, "");
        const toml::table table = toml::parse("value = " + text);
        if (table.size() == 1 && table.contains("value")) return raw_value(*table.get("value"));
    } catch (const toml::parse_error&) {  // not TOML: a bare word or quantity
    } catch (const InputError&) {         // nested too deep for any value
    }
    if (const auto number = bare_number(text)) return *number;
    return read_option_text(text);
}

std::string toml_string(std::string_view text) {
    std::string quoted = "\"";
    for (const char letter : text) {
        switch (letter) {
            case '"':
                quoted += "\\\"";
                break;
            case '\\':
                quoted += "\\\\";
                break;
            case '\n':
                quoted += "\\n";
                break;
            case '\t':
                quoted += "\\t";
                break;
            case '\r':
                quoted += "\\r";
                break;
            default: {
                const auto code = static_cast<unsigned char>(letter);
                constexpr unsigned char first_printable = 0x20;
                constexpr unsigned char del = 0x7f;
                if (code < first_printable || code == del) {
                    quoted += fmt::format("\\u{:04x}", code);
                } else {
                    quoted += letter;
                }
            }
        }
    }
    quoted += '"';
    return quoted;
}

}  // namespace riffle::inline case_file
