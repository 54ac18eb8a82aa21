#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace riffle::inline case_file {

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
    number_per_area,
    area,
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

/// Sizes beyond which a quantity cannot be meant: a wrong unit or a slip of the pen.
struct QuantityLimits {
    double least = 0.0;  ///< other than zero, SI
    double most = 0.0;
    std::string_view reason;  ///< what it is compared with
};

/// The limits of a dimension; nothing for Dimension::none.
[[nodiscard]] std::optional<QuantityLimits> quantity_limits(Dimension dimension);

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

/// A quantity for case files, with a handy unit: "50 mm". Reads back as the same double.
[[nodiscard]] std::string quantity_text(double value, Dimension dimension);

/// The handy unit of a quantity of this size that reads back as the same double in it, else the SI unit.
[[nodiscard]] std::string_view handy_unit(double value, Dimension dimension);

/// A quantity in a given unit of its dimension, which must hold it exactly; empty where it does not.
[[nodiscard]] std::string quantity_in(double value, std::string_view unit, Dimension dimension);

/// A quantity for messages, in six digits with a handy unit: 0.05600000000000001 m as "56 mm".
[[nodiscard]] std::string shown_quantity(double value, Dimension dimension);
[[nodiscard]] inline std::string shown_length(double value) {
    return shown_quantity(value, Dimension::length);
}

}  // namespace riffle::inline case_file
