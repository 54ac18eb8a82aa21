#include "case/key.hpp"

#include <array>
#include <charconv>
#include <utility>

namespace riffle::inline case_file {

double Diameters::length(double diameter) const {
    constexpr int digits = 15;
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), multiple * diameter,
                                   std::chars_format::general, digits)
                         .ptr;
    double rounded = 0.0;
    std::from_chars(buffer.data(), end, rounded);
    return rounded;
}

std::string Key::id(std::size_t item) const {
    return repeated ? section + "[" + std::to_string(item) + "]." + name : id();
}

std::optional<double> Key::number_of(const Value& value) {
    if (const auto* const number = std::get_if<double>(&value)) return *number;
    if (const auto* const integer = std::get_if<long long>(&value)) return static_cast<double>(*integer);
    return std::nullopt;
}

Key&& Key::measured_in(Dimension d) && {
    dimension = d;
    return std::move(*this);
}

Key&& Key::greater_than(double minimum) && {
    range.minimum = minimum;
    range.open_minimum = true;
    return std::move(*this);
}

Key&& Key::at_least(double minimum) && {
    range.minimum = minimum;
    return std::move(*this);
}

Key&& Key::at_most(double maximum) && {
    range.maximum = maximum;
    return std::move(*this);
}

Key&& Key::because(std::string reason) && {
    range.reason = std::move(reason);
    return std::move(*this);
}

std::optional<QuantityLimits> Key::limits() const {
    auto limits = quantity_limits(dimension);
    if (limits && !(range.minimum >= 0.0)) limits->least = 0.0;
    return limits;
}

Key&& Key::unset_by(std::string word_for_unset, std::string what_then) && {
    unset_word = std::move(word_for_unset);
    unset_meaning = std::move(what_then);
    return std::move(*this);
}

Key&& Key::with_default_note(std::string note) && {
    default_note = std::move(note);
    return std::move(*this);
}

Key&& Key::with_example(std::string text) && {
    example = std::move(text);
    return std::move(*this);
}

Key&& Key::is_required() && {
    required = true;
    return std::move(*this);
}

Key&& Key::may_be_diameters() && {
    accepts_diameters = true;
    return std::move(*this);
}

Key&& Key::may_be_empty() && {
    accepts_empty = true;
    return std::move(*this);
}

Key&& Key::may_have_several_lines() && {
    several_lines = true;
    return std::move(*this);
}

Key&& Key::applies_with(std::string other, std::vector<std::string> options, bool strictly) && {
    applies = {std::move(other), std::move(options), strictly};
    return std::move(*this);
}

Key&& Key::and_with(std::string other, std::vector<std::string> options) && {
    applies_also = {std::move(other), std::move(options), applies.strictly};
    return std::move(*this);
}

}  // namespace riffle::inline case_file
