#include "laboratory/unit.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace riffle::inline laboratory {

namespace {

struct Symbol {
    std::string_view name;
    LaboratoryUnit unit;
    bool prefixed;  ///< may carry k, d, c, m, u
};

// Exponents of metre, second, volt, kilogram.
constexpr std::array symbols{
    Symbol{"m", {1, 1, {1, 0, 0, 0}}, true},     Symbol{"s", {1, 1, {0, 1, 0, 0}}, true},
    Symbol{"V", {1, 1, {0, 0, 1, 0}}, true},     Symbol{"Hz", {1, 1, {0, -1, 0, 0}}, true},
    Symbol{"g", {1, 1000, {0, 0, 0, 1}}, true},  Symbol{"N", {1, 1, {1, -2, 0, 1}}, true},
    Symbol{"Pa", {1, 1, {-1, -2, 0, 1}}, true},  Symbol{"min", {60, 1, {0, 1, 0, 0}}, false},
    Symbol{"h", {3600, 1, {0, 1, 0, 0}}, false}, Symbol{"%", {1, 100, {0, 0, 0, 0}}, false},
    Symbol{"1", {1, 1, {0, 0, 0, 0}}, false},    Symbol{"l", {1, 1000, {3, 0, 0, 0}}, true},
    Symbol{"L", {1, 1000, {3, 0, 0, 0}}, true},
};

struct Prefix {
    char letter;
    double multiplier, divisor;
};
constexpr std::array prefixes{Prefix{'k', 1e3, 1}, Prefix{'d', 1, 10}, Prefix{'c', 1, 100},
                              Prefix{'m', 1, 1e3}, Prefix{'u', 1, 1e6}};

std::optional<LaboratoryUnit> unit_of_symbol(std::string_view name) {
    for (const Symbol& symbol : symbols) {
        if (symbol.name == name) return symbol.unit;
    }
    for (const Symbol& symbol : symbols) {
        if (!symbol.prefixed || name.size() != symbol.name.size() + 1 || name.substr(1) != symbol.name) {
            continue;
        }
        for (const Prefix& prefix : prefixes) {
            if (prefix.letter != name.front()) continue;
            LaboratoryUnit unit = symbol.unit;
            unit.multiplier *= prefix.multiplier;
            unit.divisor *= prefix.divisor;
            return unit;
        }
    }
    return std::nullopt;
}

void multiply(LaboratoryUnit& product, const LaboratoryUnit& factor, int power) {
    for (int i = 0; i < std::abs(power); ++i) {
        product.multiplier *= power > 0 ? factor.multiplier : factor.divisor;
        product.divisor *= power > 0 ? factor.divisor : factor.multiplier;
    }
    for (std::size_t i = 0; i < product.exponents.size(); ++i) {
        product.exponents[i] += power * factor.exponents[i];
    }
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
}

/// The typographic signs of units in plain letters.
std::string plain_letters(std::string_view text) {
    std::string result(text);
    replace_all(result, "\u00b5", "u");  // micro sign
    replace_all(result, "\u03bc", "u");  // Greek mu
    replace_all(result, "\u00b2", "2");
    replace_all(result, "\u00b3", "3");
    replace_all(result, "\u207b", "-");  // superscript minus
    replace_all(result, "\u00b9", "1");
    replace_all(result, "\u00b7", "*");
    return result;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '%'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Exponent behind a symbol: "2", "^2", "-1"; 1 where there is none. None where a sign has no digits.
std::optional<int> take_exponent(std::string_view& rest) {
    const bool marked = !rest.empty() && rest.front() == '^';
    if (marked) rest.remove_prefix(1);
    const bool negative = !rest.empty() && rest.front() == '-';
    if (negative) rest.remove_prefix(1);
    if (rest.empty() || !is_digit(rest.front())) {
        return marked || negative ? std::nullopt : std::optional<int>(1);
    }
    const int value = rest.front() - '0';
    rest.remove_prefix(1);
    return negative ? -value : value;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

std::optional<LaboratoryUnit> parse_unit(std::string_view text) {
    const std::string plain = plain_letters(trimmed(text));
    LaboratoryUnit result;
    if (plain.empty() || plain == "-" || plain == "1") return result;
    std::string_view rest = plain;
    int side = 1;  // -1 behind a stroke
    for (bool first = true; !rest.empty(); first = false) {
        bool stroke = false;
        bool joined = first;
        while (!rest.empty() &&
               (rest.front() == ' ' || rest.front() == '*' || rest.front() == '.' || rest.front() == '/')) {
            if (rest.front() == '/' && stroke) return std::nullopt;
            stroke = stroke || rest.front() == '/';
            joined = true;
            rest.remove_prefix(1);
        }
        if (!joined || (stroke && first)) return std::nullopt;
        if (stroke) side = -1;
        std::size_t length = 0;
        while (length < rest.size() && is_letter(rest[length])) ++length;
        if (length == 0 && first && !rest.empty() && rest.front() == '1') length = 1;  // as in 1/s
        const auto unit = unit_of_symbol(rest.substr(0, length));
        if (!unit) return std::nullopt;
        rest.remove_prefix(length);
        const auto exponent = take_exponent(rest);
        if (!exponent) return std::nullopt;
        multiply(result, *unit, side * *exponent);
    }
    return result;
}

std::optional<double> parse_quantity(std::string_view text, std::string_view unit) {
    const std::string_view whole = trimmed(text);
    double value = 0;
    const std::size_t sign = !whole.empty() && whole.front() == '+' ? 1 : 0;
    const char* const end = whole.data() + whole.size();
    const auto [stop, error] = std::from_chars(whole.data() + sign, end, value);
    if (error != std::errc{}) return std::nullopt;
    const std::string_view symbol = trimmed(whole.substr(static_cast<std::size_t>(stop - whole.data())));
    const auto expected = parse_unit(unit);
    if (symbol.empty()) return value;
    const auto given = parse_unit(symbol);
    if (!given || !expected || !given->same_dimension(*expected)) return std::nullopt;
    return given->to_si(value);
}

}  // namespace riffle::inline laboratory
