#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace riffle::inline laboratory {

/// A unit of a laboratory file: value in SI = value * multiplier / divisor (two numbers, so that 35 mm is
/// 0.035 to the last bit), and its exponents of metre, second, volt and kilogram.
struct LaboratoryUnit {
    double multiplier = 1;
    double divisor = 1;
    std::array<int, 4> exponents{};

    [[nodiscard]] double to_si(double value) const { return value * multiplier / divisor; }
    [[nodiscard]] bool same_dimension(const LaboratoryUnit& other) const {
        return exponents == other.exponents;
    }
    [[nodiscard]] bool is_si() const { return multiplier == divisor; }
};

/// Read a unit: products and quotients of m, s, min, h, V, Hz, g, N, Pa with the prefixes k, d, c, m, u and
/// whole exponents, like "mm", "cm/s", "m2/s2", "m^2/s^2", "m s-1", "mm/V"; "1", "-" and "" are without
/// dimension, "%" is a hundredth. None if it is not understood.
[[nodiscard]] std::optional<LaboratoryUnit> parse_unit(std::string_view text);

/// A number that may be followed by a unit, like "28 mm" or "-0.5 cm/s", in SI. None if it is not a number,
/// the unit is not understood or has another dimension than `unit`. A number alone is in `unit`, which is an
/// SI unit.
[[nodiscard]] std::optional<double> parse_quantity(std::string_view text, std::string_view unit);

/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The whole text as a number with a decimal point; none if it is not one.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

}  // namespace riffle::inline laboratory
