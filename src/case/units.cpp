#include "case/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace riffle::inline case_file {

namespace {

constexpr std::array<Unit, 6> length_units{
    {{"m", 1, 1}, {"dm", 1, 10}, {"cm", 1, 100}, {"mm", 1, 1000}, {"um", 1, 1e6}, {"km", 1000, 1}}};
constexpr std::array<Unit, 5> time_units{
    {{"s", 1, 1}, {"ms", 1, 1000}, {"us", 1, 1e6}, {"min", 60, 1}, {"h", 3600, 1}}};
constexpr std::array<Unit, 3> velocity_units{{{"m/s", 1, 1}, {"cm/s", 1, 100}, {"mm/s", 1, 1000}}};
constexpr std::array<Unit, 3> acceleration_units{{{"m/s2", 1, 1}, {"cm/s2", 1, 100}, {"mm/s2", 1, 1000}}};
constexpr std::array<Unit, 3> viscosity_units{{{"m2/s", 1, 1}, {"cm2/s", 1, 1e4}, {"mm2/s", 1, 1e6}}};
constexpr std::array<Unit, 2> density_units{{{"kg/m3", 1, 1}, {"g/cm3", 1000, 1}}};
constexpr std::array<Unit, 2> discharge_units{{{"m3/s", 1, 1}, {"l/s", 1, 1000}}};
constexpr std::array<Unit, 2> frequency_units{{{"Hz", 1, 1}, {"kHz", 1000, 1}}};
constexpr std::array<Unit, 2> number_per_area_units{{{"1/m2", 1, 1}, {"1/cm2", 1e4, 1}}};

constexpr std::array<Unit, 3> area_units{{{"m2", 1, 1}, {"cm2", 1, 1e4}, {"mm2", 1, 1e6}}};

constexpr std::array dimensions{Dimension::length,       Dimension::time,      Dimension::velocity,
                                Dimension::acceleration, Dimension::density,   Dimension::kinematic_viscosity,
                                Dimension::discharge,    Dimension::frequency, Dimension::number_per_area,
                                Dimension::area};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::span<const Unit> units_of(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            return {};
        case Dimension::length:
            return length_units;
        case Dimension::time:
            return time_units;
        case Dimension::velocity:
            return velocity_units;
        case Dimension::acceleration:
            return acceleration_units;
        case Dimension::kinematic_viscosity:
            return viscosity_units;
        case Dimension::density:
            return density_units;
        case Dimension::discharge:
            return discharge_units;
        case Dimension::frequency:
            return frequency_units;
        case Dimension::number_per_area:
            return number_per_area_units;
        case Dimension::area:
            return area_units;
    }
    return {};
}

std::string_view dimension_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            return "a number without unit";
        case Dimension::length:
            return "a length";
        case Dimension::time:
            return "a time";
        case Dimension::velocity:
            return "a velocity";
        case Dimension::acceleration:
            return "an acceleration";
        case Dimension::kinematic_viscosity:
            return "a kinematic viscosity or a discharge per unit width";
        case Dimension::density:
            return "a density";
        case Dimension::discharge:
            return "a discharge";
        case Dimension::frequency:
            return "a frequency";
        case Dimension::number_per_area:
            return "a number per area";
        case Dimension::area:
            return "an area";
    }
    return "";
}

std::string_view si_unit(Dimension dimension) {
    const auto units = units_of(dimension);
    return units.empty() ? std::string_view{} : units.front().symbol;
}

std::string unit_list(Dimension dimension) {
    std::string list;
    for (const Unit& unit : units_of(dimension)) {
        list += list.empty() ? "" : ", ";
        list += unit.symbol;
    }
    return list;
}

std::optional<QuantityLimits> quantity_limits(Dimension dimension) {
    switch (dimension) {
        case Dimension::none:
            break;
        case Dimension::length:
            return {{1e-9, 1e5, "molecules are larger, and no reach of 100 km is made of particles"}};
        case Dimension::time:
            return {{1e-9, 1e9, "no step is shorter, and 1e9 s are thirty years"}};
        case Dimension::velocity:
            return {{1e-9, 1e4, "sound in water has 1.5e3 m/s"}};
        case Dimension::acceleration:
            return {{1e-9, 1e4, "centrifuges for models reach a few hundred times gravity, 3e3 m/s2"}};
        case Dimension::kinematic_viscosity:
            return {{1e-12, 1e4, "water has 1e-6 m2/s, honey 1e-2 m2/s, lava up to 1e2 m2/s"}};
        case Dimension::density:
            return {{1e-3, 1e5, "air has 1.2 kg/m3, water 1e3 kg/m3, osmium 2.3e4 kg/m3"}};
        case Dimension::discharge:
            return {{1e-12, 1e7, "the Amazon carries 2e5 m3/s"}};
        case Dimension::frequency:
            return {{1e-9, 1e9, "no step is shorter, and 1e9 s are thirty years"}};
        case Dimension::number_per_area:
            return {{1e-6, 1e8, "a dense lawn has 1e5 1/m2"}};
        case Dimension::area:
            return {{1e-20, 1e-2, "clay has a permeability of 1e-18 m2, boulders one of 1e-4 m2"}};
    }
    return std::nullopt;
}

std::optional<Dimension> dimension_of_unit(std::string_view symbol) {
    for (const Dimension dimension : dimensions) {
        for (const Unit& unit : units_of(dimension)) {
            if (unit.symbol == symbol) return dimension;
        }
    }
    return std::nullopt;
}

std::optional<Quantity> split_quantity(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    Quantity quantity;
    const char* const last = text.data() + text.size();
    const auto [end, status] = std::from_chars(text.data(), last, quantity.value);
    if (status != std::errc{} || !std::isfinite(quantity.value)) {
        return std::nullopt;
    }
    quantity.unit = trimmed(std::string_view(end, static_cast<std::size_t>(last - end)));
    replace_all(quantity.unit, "^", "");
    replace_all(quantity.unit, "\u00b2", "2");  // superscript two and three, micro sign
    replace_all(quantity.unit, "\u00b3", "3");
    replace_all(quantity.unit, "\u00b5", "u");
    return quantity;
}

std::optional<double> to_si(const Quantity& quantity, Dimension dimension) {
    if (quantity.unit.empty()) return quantity.value;
    for (const Unit& unit : units_of(dimension)) {
        if (unit.symbol == quantity.unit) return quantity.value * unit.multiplier / unit.divisor;
    }
    return std::nullopt;
}

std::string number_text(double value) {
    std::array<char, 40> buffer{};
    const auto [end, status] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    std::string text(buffer.data(), end);
    if (status == std::errc{} && text.find_first_of(".en") == std::string::npos) {
        text += ".0";  // TOML: a float has a point or an exponent
    }
    return text;
}

std::string quantity_in(double value, std::string_view unit, Dimension dimension) {
    double scaled = value;
    for (const Unit& known : units_of(dimension)) {
        if (known.symbol == unit && known.divisor != known.multiplier) {
            // Round away the noise of the multiplication, but only when the exact value survives.
            scaled = std::round(value * known.divisor / known.multiplier * 1e6) / 1e6;
            if (scaled * known.multiplier / known.divisor != value) return "";
        }
    }
    std::array<char, 40> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), scaled).ptr;
    std::string text(buffer.data(), end);
    if (!unit.empty()) {
        text += " ";
        text += unit;
    }
    return text;
}

std::string_view handy_unit(double value, Dimension dimension) {
    const double size = std::abs(value);
    const std::string_view handy = dimension != Dimension::length || value == 0.0 || size >= 1.0 ? ""
                                   : size < 1e-4                                                 ? "um"
                                                                                                 : "mm";
    return handy.empty() || quantity_in(value, handy, dimension).empty() ? si_unit(dimension) : handy;
}

std::string quantity_text(double value, Dimension dimension) {
    return quantity_in(value, handy_unit(value, dimension), dimension);
}

std::string shown_quantity(double value, Dimension dimension) {
    if (dimension != Dimension::length || value == 0.0) {
        const std::string_view unit = si_unit(dimension);
        return fmt::format("{:.6g}{}{}", value, unit.empty() ? "" : " ", unit);
    }
    const double size = std::abs(value);
    const auto text = [&](double factor, const char* unit) {
        return fmt::format("{:.6g} {}", factor * value, unit);
    };
    return size < 9.999995e-5 ? text(1e6, "um") : size < 0.9999995 ? text(1e3, "mm") : text(1.0, "m");
}

}  // namespace riffle::inline case_file
