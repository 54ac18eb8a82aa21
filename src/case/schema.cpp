#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "case/case_documents.hpp"
#include "case/conversion.hpp"
#include "case/key_table.hpp"

namespace riffle::inline case_file {

namespace {

using Json = nlohmann::ordered_json;

/// Regular expression of a number with one of the units of the key.
std::string quantity_pattern(const Key& key) {
    std::string units;
    for (const Unit& unit : units_of(key.dimension)) {
        units += units.empty() ? "" : "|";
        for (const char letter : unit.symbol) {
            // "m2/s" may be written "m^2/s" or with a superscript, as the reader takes it.
            switch (letter) {
                case '2':
                    units += "(\\^?2|\u00b2)";
                    break;
                case '3':
                    units += "(\\^?3|\u00b3)";
                    break;
                default:
                    units += letter;
            }
        }
    }
    if (key.accepts_diameters) units += "|D";
    return R"(^\s*[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?\s*()" + units + R"()\s*$)";
}

Json number_schema(const Key& key) {
    Json schema{{"type", key.type == ValueType::integer ? "integer" : "number"}};
    const double most = key.limits() ? key.limits()->most : std::numeric_limits<double>::infinity();
    const double minimum = std::max(key.range.minimum, -most);
    const double maximum = std::min(key.range.maximum, most);
    if (std::isfinite(minimum)) schema[key.range.open_minimum ? "exclusiveMinimum" : "minimum"] = minimum;
    if (std::isfinite(maximum)) schema["maximum"] = maximum;
    return schema;
}

/// What an option is and where it is advised.
std::string described(const Word& option) {
    return option.advice.empty() ? std::string(option.meaning)
                                 : fmt::format("{}. Advice: {}", option.meaning, option.advice);
}

/// What a single value of a key may be.
Json choices(const Key& key) {
    Json list = Json::array();
    switch (key.type) {
        case ValueType::number:
        case ValueType::integer:
            list.push_back(number_schema(key));
            break;
        case ValueType::boolean:
            list.push_back({{"type", "boolean"}});
            break;
        case ValueType::word:
            for (const Word& option : key.words) {
                list.push_back({{"const", option.name}, {"description", described(option)}});
            }
            break;
        case ValueType::text:
        case ValueType::file:
            list.push_back({{"type", "string"}});
            break;
    }
    if (key.dimension != Dimension::none) {
        list.push_back({{"type", "string"}, {"pattern", quantity_pattern(key)}});
    }
    if (!key.unset_word.empty()) {
        list.push_back({{"const", key.unset_word}, {"description", key.unset_meaning}});
    }
    return list;
}

Json key_schema(const Key& key) {
    Json list = choices(key);
    if (key.list) {
        list.push_back(
            {{"type", "array"}, {"minItems", key.accepts_empty ? 0 : 1}, {"items", {{"oneOf", list}}}});
    }
    Json schema = list.size() == 1 ? list.front() : Json{{"oneOf", list}};
    schema["description"] = key.meaning;
    if (!key.required && key.default_note.empty()) {
        const Value value = key.get(Case{});
        schema["default"] = Json::parse(value_text(key, value));
    }
    return schema;
}

Json section_schema(const SectionKeys& section) {
    Json schema{{"type", "object"}, {"description", section.meaning}, {"additionalProperties", false}};
    Json required = Json::array();
    for (const Key& key : section.keys) {
        schema["properties"][key.name] = key_schema(key);
        if (key.required) required.push_back(key.name);
    }
    if (!required.empty()) schema["required"] = required;
    return schema;
}

}  // namespace

std::string case_schema_json() {
    Json schema;
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
    schema["title"] = "Riffle case file";
    schema["description"] =
        "A case of open-channel flow over a rough bed. Numbers are SI; texts carry a unit.";
    schema["type"] = "object";
    schema["additionalProperties"] = false;
    schema["properties"] = section_schema(key_table().front())["properties"];
    Json required = Json::array();
    for (const SectionKeys& section : key_table()) {
        if (section.name.empty()) continue;
        Json inner = section_schema(section);
        if (section.repeated()) {
            inner = {{"type", "array"}, {"items", inner}};
        } else if (inner.contains("required")) {
            required.push_back(section.name);
        }
        schema["properties"][section.name] = inner;
    }
    schema["required"] = required;
    constexpr int indent = 2;
    return schema.dump(indent) + "\n";
}

}  // namespace riffle::inline case_file
