#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case/case.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

/// A length given as a multiple of the sphere diameter: "0.4 D".
struct Diameters {
    double multiple = 0.0;

    /// The length for a diameter, rounded to 15 digits so that "0.4 D" of 25 mm is the same as "10 mm".
    [[nodiscard]] double length(double diameter) const;

    bool operator==(const Diameters&) const = default;
};

/// A value of a key after reading: unset (the key's unset word, "auto" say), or what its type says. Numbers
/// are SI; words and file names are strings; lists are of numbers.
using Value =
    std::variant<std::monostate, bool, long long, double, std::string, Diameters, std::vector<double>>;

/// What a key holds.
enum class ValueType { number, integer, boolean, word, text, file };

/// Allowed range of a number.
struct Range {
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool open_minimum = false;  ///< the minimum itself is not allowed
    std::string reason;         ///< why no further, where the meaning of the key does not say so

    [[nodiscard]] bool contains(double value) const {
        return (open_minimum ? value > minimum : value >= minimum) && value <= maximum;
    }
};

/// The options of another key under which a key has an effect.
struct Applies {
    std::string id;  ///< "section.key"; empty: always
    std::vector<std::string> words;
    bool strictly = false;  ///< giving the key otherwise is an error, not a warning
};

/// One key of the case file. The table of all keys (key_table.hpp) is the only place that knows them:
/// reading, validation, messages, schema, reference page, template and normalised text are all made from it.
struct Key {
    std::string section;  ///< empty for the keys before the first section
    std::string name;
    std::string meaning;
    ValueType type = ValueType::number;
    Dimension dimension = Dimension::none;
    Range range;
    std::vector<Word> words;
    std::string unset_word;  ///< word for "not set"; empty: the key cannot be unset
    std::string unset_meaning;
    std::string default_note;  ///< where the default depends on other keys
    std::string example;       ///< a right value, as written in a case file
    bool required = false;
    bool accepts_diameters = false;
    bool list = false;           ///< one number or a list of them; empty: not given
    bool accepts_empty = false;  ///< a list that may be written as []: not given
    bool repeated = false;       ///< of a section that may stand several times, [[section]]
    bool several_lines = false;  ///< a text that may hold line breaks and tabs
    Applies applies;
    Applies applies_also;  ///< a second condition; both must hold
    std::function<Value(const Case&, std::size_t item)> read;
    std::function<void(Case&, const Value&, std::size_t item)> write;

    /// The value in a case. `item`: which of the sections of this name, where it is a repeated one; behind
    /// the last one the default.
    [[nodiscard]] Value get(const Case& c, std::size_t item = 0) const { return read(c, item); }
    /// Set the value; an `item` that is not yet there is made.
    void set(Case& c, const Value& value, std::size_t item = 0) const { write(c, value, item); }

    /// "section.key", or "key" before the first section.
    [[nodiscard]] std::string id() const { return section.empty() ? name : section + "." + name; }
    /// The same for one of several sections of a name: "probe[2].name".
    [[nodiscard]] std::string id(std::size_t item) const;

    /// The limits of its dimension, where they are narrower than its own range: for a key that takes no
    /// negative numbers both, else the largest size alone (a place may be as near to zero as it likes).
    [[nodiscard]] std::optional<QuantityLimits> limits() const;

    /// The number of `value`, for numbers and integers.
    [[nodiscard]] static std::optional<double> number_of(const Value& value);

    // Builders, for the rows of the table.
    Key&& measured_in(Dimension d) &&;
    Key&& greater_than(double minimum) &&;
    Key&& at_least(double minimum) &&;
    Key&& at_most(double maximum) &&;
    Key&& because(std::string reason) &&;
    Key&& unset_by(std::string word_for_unset, std::string what_then) &&;
    Key&& with_default_note(std::string note) &&;
    Key&& with_example(std::string text) &&;
    Key&& is_required() &&;
    Key&& may_be_diameters() &&;
    Key&& may_be_empty() &&;
    Key&& may_have_several_lines() &&;
    Key&& applies_with(std::string other, std::vector<std::string> options, bool strictly = false) &&;
    Key&& and_with(std::string other, std::vector<std::string> options) &&;
};

namespace detail {

/// Type and conversions of the members that a key may be bound to.
template <class T>
struct Binding;

template <>
struct Binding<double> {
    static constexpr ValueType type = ValueType::number;
    static Value to_value(double member) { return member; }
    static double from_value(const Value& value) { return std::get<double>(value); }
};

template <>
struct Binding<int> {
    static constexpr ValueType type = ValueType::integer;
    static Value to_value(int member) { return static_cast<long long>(member); }
    static int from_value(const Value& value) { return static_cast<int>(std::get<long long>(value)); }
};

template <>
struct Binding<long long> {
    static constexpr ValueType type = ValueType::integer;
    static Value to_value(long long member) { return member; }
    static long long from_value(const Value& value) { return std::get<long long>(value); }
};

template <>
struct Binding<bool> {
    static constexpr ValueType type = ValueType::boolean;
    static Value to_value(bool member) { return member; }
    static bool from_value(const Value& value) { return std::get<bool>(value); }
};

/// A member that may be unset.
template <class T>
struct Binding<std::optional<T>> {
    static constexpr ValueType type = Binding<T>::type;
    static Value to_value(const std::optional<T>& member) { return member ? Value(*member) : Value(); }
    static std::optional<T> from_value(const Value& value) {
        const auto* const given = std::get_if<T>(&value);
        return given ? std::optional(*given) : std::nullopt;
    }
};

template <>
struct Binding<std::string> {
    static constexpr ValueType type = ValueType::text;
    static Value to_value(const std::string& member) { return member; }
    static std::string from_value(const Value& value) { return std::get<std::string>(value); }
};

template <>
struct Binding<std::filesystem::path> {
    static constexpr ValueType type = ValueType::file;
    static Value to_value(const std::filesystem::path& member) { return member.string(); }
    static std::filesystem::path from_value(const Value& value) { return std::get<std::string>(value); }
};

template <>
struct Binding<std::vector<double>> {
    static constexpr ValueType type = ValueType::number;
    static Value to_value(const std::vector<double>& member) { return member; }
    static std::vector<double> from_value(const Value& value) { return std::get<std::vector<double>>(value); }
};

template <class Enum>
requires std::is_enum_v<Enum>
struct Binding<Enum> {
    static constexpr ValueType type = ValueType::word;
    static Value to_value(Enum member) { return std::string(word(member)); }
    static Enum from_value(const Value& value) {
        const auto& list = Words<Enum>::list;
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].name == std::get<std::string>(value)) return static_cast<Enum>(i);
        }
        throw std::bad_variant_access();  // not reached: the reader has checked the word
    }
};

template <class T>
Key make_key(std::string section, std::string name, std::string meaning) {
    Key key;
    key.section = std::move(section);
    key.name = std::move(name);
    key.meaning = std::move(meaning);
    key.type = Binding<T>::type;
    if constexpr (std::is_enum_v<T>) key.words.assign(Words<T>::list.begin(), Words<T>::list.end());
    if constexpr (std::is_same_v<T, std::optional<double>>) key.unset_word = "auto";
    key.list = std::is_same_v<T, std::vector<double>>;
    return key;
}

}  // namespace detail

/// A key bound to a member of a section of the case.
template <class Section, class T>
Key make_key(std::string section, std::string name, Section Case::*part, T Section::*member,
             std::string meaning) {
    Key key = detail::make_key<T>(std::move(section), std::move(name), std::move(meaning));
    key.read = [part, member](const Case& c, std::size_t) {
        return detail::Binding<T>::to_value(c.*part.*member);
    };
    key.write = [part, member](Case& c, const Value& value, std::size_t) {
        c.*part.*member = detail::Binding<T>::from_value(value);
    };
    return key;
}

/// A key bound to a member of each item of a repeated section.
template <class Item, class T>
Key make_key(std::string section, std::string name, std::vector<Item> Case::*items, T Item::*member,
             std::string meaning) {
    Key key = detail::make_key<T>(std::move(section), std::move(name), std::move(meaning));
    key.repeated = true;
    key.read = [items, member](const Case& c, std::size_t item) {
        const std::vector<Item>& list = c.*items;
        return detail::Binding<T>::to_value(item < list.size() ? list[item].*member : Item{}.*member);
    };
    key.write = [items, member](Case& c, const Value& value, std::size_t item) {
        std::vector<Item>& list = c.*items;
        list.resize(std::max(list.size(), item + 1));
        list[item].*member = detail::Binding<T>::from_value(value);
    };
    return key;
}

/// A key bound to a member of the case itself.
template <class T>
Key make_key(std::string name, T Case::*member, std::string meaning) {
    Key key = detail::make_key<T>("", std::move(name), std::move(meaning));
    key.read = [member](const Case& c, std::size_t) { return detail::Binding<T>::to_value(c.*member); };
    key.write = [member](Case& c, const Value& value, std::size_t) {
        c.*member = detail::Binding<T>::from_value(value);
    };
    return key;
}

}  // namespace riffle::inline case_file
