#include "case/conversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/visible_text.hpp"
#include "case/nearest.hpp"

namespace riffle::inline case_file {

namespace {

std::string raw_text(const RawValue& raw) {
    struct Text {
        std::string operator()(bool value) const { return value ? "true" : "false"; }
        std::string operator()(long long value) const { return std::to_string(value); }
        std::string operator()(double value) const { return fmt::format("{}", value); }
        std::string operator()(const std::string& value) const { return toml_string(shortened(value)); }
        std::string operator()(const OtherValue& value) const { return value.kind; }
        std::string operator()(const RawList&) const { return "an array"; }
    };
    return std::visit(Text{}, raw);
}

std::string joined_words(const Key& key) {
    std::string list;
    for (const Word& option : key.words) {
        list += list.empty() ? "" : ", ";
        list += option.name;
    }
    return list;
}

/// How to write a value of this key.
std::string how_to_write(const Key& key) {
    if (key.type == ValueType::number && key.dimension != Dimension::none) {
        std::string text = fmt::format("write a number in {} or a text with one of the units {}",
                                       si_unit(key.dimension), unit_list(key.dimension));
        if (key.accepts_diameters) text += ", or a multiple of the sphere diameter such as \"0.4 D\"";
        return text;
    }
    switch (key.type) {
        case ValueType::number:
            return "write a number without quotes";
        case ValueType::integer:
            return "write a whole number without quotes";
        case ValueType::boolean:
            return "write true or false without quotes";
        case ValueType::word:
        case ValueType::text:
        case ValueType::file:
            return "write it in quotes";
    }
    return "";
}

std::string wrong(const Key& key, const RawValue& raw, const std::string& advice) {
    return fmt::format("{} = {}: expected {}; {}", shown_name(key), raw_text(raw), expectation(key), advice);
}

std::string limit_text(double value, Dimension dimension) {
    return fmt::format("{:g} {}", value, si_unit(dimension));
}

std::variant<Value, std::string> checked_number(const Key& key, const RawValue& raw, double number) {
    if (!std::isfinite(number)) return wrong(key, raw, "a finite number is needed");
    if (!key.range.contains(number)) return wrong(key, raw, "correct the value");
    const auto limits = key.limits();
    const double size = std::abs(number);
    if (limits && number != 0.0 && (size < limits->least || size > limits->most)) {
        const bool small = size < limits->least;
        return fmt::format("{} = {}: {} {}, {} than can be meant ({}); correct the value or its unit",
                           shown_name(key), raw_text(raw), small ? "less than" : "more than",
                           limit_text(small ? limits->least : limits->most, key.dimension),
                           small ? "smaller" : "larger", limits->reason);
    }
    return Value(number + 0.0);  // no negative zero: it is another number in the text of a case
}

std::variant<Value, std::string> convert_word(const Key& key, const RawValue& raw, const std::string& text) {
    std::vector<std::string> names;
    for (const Word& option : key.words) {
        if (option.name == text) return Value(text);
        names.emplace_back(option.name);
    }
    const auto meant = nearest_name(text, names);
    return wrong(key, raw, meant ? fmt::format("did you mean \"{}\"?", *meant) : "choose one of them");
}

/// A number given as text: a quantity with its unit, or the word for "not set".
std::variant<Value, std::string> convert_quantity(const Key& key, const RawValue& raw,
                                                  const std::string& text) {
    const auto quantity = split_quantity(text);
    if (!quantity) {
        if (!key.unset_word.empty()) {
            if (const auto meant = nearest_name(text, std::vector{key.unset_word})) {
                return wrong(key, raw, fmt::format("did you mean \"{}\"?", *meant));
            }
        }
        return wrong(key, raw, how_to_write(key));
    }
    if (key.accepts_diameters && quantity->unit == "D") {
        if (quantity->value < 0) return wrong(key, raw, "correct the value");
        return Value(Diameters{quantity->value + 0.0});
    }
    if (quantity->unit.empty()) {
        return wrong(key, raw,
                     key.dimension == Dimension::none
                         ? how_to_write(key)
                         : fmt::format("a text needs a unit ({}); a number without quotes is in {}",
                                       unit_list(key.dimension), si_unit(key.dimension)));
    }
    if (const auto number = to_si(*quantity, key.dimension)) return checked_number(key, raw, *number);
    const auto other = dimension_of_unit(quantity->unit);
    return wrong(key, raw,
                 fmt::format("`{}` is {}; {}", shortened(quantity->unit),
                             other ? fmt::format("the unit of {}", dimension_name(*other)) : "no known unit",
                             how_to_write(key)));
}

std::variant<Value, std::string> convert_number(const Key& key, const RawValue& raw) {
    if (const auto* const integer = std::get_if<long long>(&raw)) {
        return checked_number(key, raw, static_cast<double>(*integer));
    }
    if (const auto* const number = std::get_if<double>(&raw)) return checked_number(key, raw, *number);
    if (const auto* const text = std::get_if<std::string>(&raw)) return convert_quantity(key, raw, *text);
    return wrong(key, raw, how_to_write(key));
}

/// A text goes to terminals, logs, pages and names of files: it must hold nothing that these would obey.
std::variant<Value, std::string> convert_text(const Key& key, const std::string& text) {
    if (const auto hidden = hidden_character(text, 0, key.several_lines ? "\n\t" : "")) {
        return fmt::format("{} holds the control character {} after \"{}\": remove it{}", shown_name(key),
                           hidden->name, shortened(text.substr(0, hidden->place)),
                           key.several_lines ? "; line breaks and tabs may stay" : "");
    }
    constexpr std::size_t longest_name = 4096;
    if (key.type == ValueType::file && text.size() > longest_name) {
        return fmt::format("{} is {} letters long: expected the name of a file, of at most {}",
                           shown_name(key), text.size(), longest_name);
    }
    return Value(text);
}

/// The part of a raw value that is no list.
struct Single {
    RawScalar operator()(const RawList&) const { return OtherValue{"an array"}; }
    template <class T>
    RawScalar operator()(const T& scalar) const {
        return scalar;
    }
};

/// A list of numbers; a single one is a list of one.
std::variant<Value, std::string> convert_list(const Key& key, const RawValue& raw) {
    std::vector<RawScalar> items;
    if (const auto* const list = std::get_if<RawList>(&raw)) {
        items = list->items;
    } else {
        items.push_back(std::visit(Single{}, raw));
    }
    if (items.empty() && !key.accepts_empty) {
        return fmt::format("{} = []: expected {}; give at least one", shown_name(key), expectation(key));
    }
    if (items.size() > longest_list) {
        return fmt::format(
            "{} holds {} values: expected at most {}; leave out what is finer than the particle spacing",
            shown_name(key), items.size(), longest_list);
    }
    std::vector<double> numbers;
    for (const RawScalar& item : items) {
        auto converted =
            convert_number(key, std::visit([](const auto& scalar) { return RawValue(scalar); }, item));
        if (auto* const message = std::get_if<std::string>(&converted)) return std::move(*message);
        numbers.push_back(std::get<double>(std::get<Value>(converted)));
    }
    return Value(std::move(numbers));
}

template <class F>
std::string list_text(const std::vector<double>& numbers, const F& text) {
    if (numbers.size() == 1) return text(numbers.front());
    std::string list;
    for (const double number : numbers) list += (list.empty() ? "" : ", ") + text(number);
    return "[" + list + "]";
}

}  // namespace

std::string shown_name(const Key& key) {
    if (key.section.empty()) return key.name;
    return key.repeated ? fmt::format("[[{}]] {}", key.section, key.name)
                        : fmt::format("[{}] {}", key.section, key.name);
}

std::string range_text(const Key& key) {
    const bool integer = key.type == ValueType::integer;
    const auto bound = [&](double value) {
        const std::string number =
            integer ? std::to_string(static_cast<long long>(value)) : fmt::format("{:g}", value);
        const auto unit = si_unit(key.dimension);
        return value == 0.0 || unit.empty() ? number : fmt::format("{} {}", number, unit);
    };
    if (integer && key.range.maximum == key.range.minimum + 1.0) {
        return fmt::format("{} or {}", bound(key.range.minimum), bound(key.range.maximum));
    }
    std::string text;
    if (std::isfinite(key.range.minimum)) {
        text = fmt::format("{} {}", key.range.open_minimum ? "greater than" : "at least",
                           bound(key.range.minimum));
    }
    if (std::isfinite(key.range.maximum)) {
        text += fmt::format("{}at most {}", text.empty() ? "" : " and ", bound(key.range.maximum));
    }
    return text;
}

std::string expectation(const Key& key) {
    std::string text;
    switch (key.type) {
        case ValueType::number:
            text =
                key.dimension == Dimension::none ? "a number (without unit)" : dimension_name(key.dimension);
            break;
        case ValueType::integer:
            text = "a whole number";
            break;
        case ValueType::boolean:
            text = "true or false";
            break;
        case ValueType::word:
            text = "one of the words " + joined_words(key);
            break;
        case ValueType::text:
            text = "a text";
            break;
        case ValueType::file:
            text = "the name of a file";
            break;
    }
    const std::string range = range_text(key);
    text += range.empty() ? "" : " " + range;
    text += key.range.reason.empty() ? "" : fmt::format(" ({})", key.range.reason);
    text += key.list ? ", or a list of them" : "";
    if (!key.unset_word.empty()) {
        text += fmt::format(", or \"{}\"", key.unset_word);
    }
    return text;
}

std::variant<Value, std::string> convert(const Key& key, const RawValue& raw) {
    const auto* const text = std::get_if<std::string>(&raw);
    if (text != nullptr && !key.unset_word.empty() && *text == key.unset_word) return Value();
    if (key.list) return convert_list(key, raw);
    switch (key.type) {
        case ValueType::number:
            return convert_number(key, raw);
        case ValueType::integer: {
            const auto* const integer = std::get_if<long long>(&raw);
            if (integer == nullptr) return wrong(key, raw, how_to_write(key));
            const bool allowed = key.range.contains(static_cast<double>(*integer));
            return allowed ? std::variant<Value, std::string>(Value(*integer))
                           : wrong(key, raw, "correct the value");
        }
        case ValueType::boolean: {
            const auto* const boolean = std::get_if<bool>(&raw);
            return boolean != nullptr ? std::variant<Value, std::string>(Value(*boolean))
                                      : wrong(key, raw, how_to_write(key));
        }
        case ValueType::word:
            return text != nullptr ? convert_word(key, raw, *text) : wrong(key, raw, how_to_write(key));
        case ValueType::text:
        case ValueType::file:
            return text != nullptr ? convert_text(key, *text) : wrong(key, raw, how_to_write(key));
    }
    return Value();
}

std::string value_text(const Key& key, const Value& value) {
    struct Text {
        const Key& key;
        std::string operator()(std::monostate) const { return toml_string(key.unset_word); }
        std::string operator()(bool boolean) const { return boolean ? "true" : "false"; }
        std::string operator()(long long integer) const { return std::to_string(integer); }
        std::string operator()(double number) const { return number_text(number); }
        std::string operator()(const std::string& text) const { return toml_string(text); }
        std::string operator()(const Diameters& diameters) const {
            return fmt::format("\"{} D\"", diameters.multiple);
        }
        std::string operator()(const std::vector<double>& numbers) const {
            return list_text(numbers, [](double number) { return number_text(number); });
        }
    };
    return std::visit(Text{key}, value);
}

std::string handy_value_text(const Key& key, const Value& value) {
    const auto handy = [&](double number) {
        const std::string text = quantity_text(number, key.dimension);
        return key.dimension == Dimension::none ? text : toml_string(text);
    };
    if (const auto* const numbers = std::get_if<std::vector<double>>(&value)) {
        // All in one unit, that of the largest, if it holds each of them exactly.
        const double largest =
            std::accumulate(numbers->begin(), numbers->end(), 0.0,
                            [](double most, double number) { return std::max(most, std::abs(number)); });
        const std::string_view unit = handy_unit(largest, key.dimension);
        const bool one = std::none_of(numbers->begin(), numbers->end(), [&](double number) {
            return quantity_in(number, unit, key.dimension).empty();
        });
        return list_text(*numbers, [&](double number) {
            return one && !unit.empty() ? toml_string(quantity_in(number, unit, key.dimension))
                                        : handy(number);
        });
    }
    const auto* const number = std::get_if<double>(&value);
    return number != nullptr ? handy(*number) : value_text(key, value);
}

}  // namespace riffle::inline case_file
