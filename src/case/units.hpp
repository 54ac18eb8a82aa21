#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace riffle {

/// What a number of the case file measures.
enum class Dimension {
    none,
    length,
    time,
    velocity,
    acceleration,
    kinematic_viscosity,
    density,
    discharge,
    frequency,
};

/// A unit: value in SI = value * multiplier / divisor. Two whole numbers, so that "50 mm" is exactly 0.05.
struct Unit {
    std::string_view symbol;
    double multiplier;
    double divisor;
};

/// The accepted units of a dimension, the SI unit first; empty for Dimension::none.
[[nodiscard]] std::span<const Unit> units_of(Dimension dimension);

/// Name of a dimension with its article: "a length"; Dimension::none: "a number without unit".
[[nodiscard]] std::string_view dimension_name(Dimension dimension);

/// Symbol of the SI unit, empty for Dimension::none.
[[nodiscard]] std::string_view si_unit(Dimension dimension);

/// The accepted units as text: "m, dm, cm, mm, um, km".
[[nodiscard]] std::string unit_list(Dimension dimension);

/// The dimension that a unit symbol belongs to, if it is known at all.
[[nodiscard]] std::optional<Dimension> dimension_of_unit(std::string_view symbol);

/// A number and the symbol behind it, in the spelling of the unit tables ("m2/s" for "m^2/s").
struct Quantity {
    double value = 0.0;
    std::string unit;
};

/// Split "50 mm" or "2.5cm" into number and symbol; no value when it does not begin with a number.
[[nodiscard]] std::optional<Quantity> split_quantity(std::string_view text);

/// Value in SI; no value when the unit does not belong to the dimension.
[[nodiscard]] std::optional<double> to_si(const Quantity& quantity, Dimension dimension);

/// Shortest TOML float that reads back as the same double.
[[nodiscard]] std::string number_text(double value);

/// A quantity for people, with a handy unit: "50 mm". Reads back as the same double.
[[nodiscard]] std::string quantity_text(double value, Dimension dimension);

}  // namespace riffle
