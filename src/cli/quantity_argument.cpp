#include "cli/quantity_argument.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace riffle::inline cli {

double quantity_argument(const std::string& option, const std::string& text, Dimension dimension) {
    if (const std::optional<Quantity> quantity = split_quantity(text)) {
        const std::optional<double> value =
            quantity->unit.empty() ? std::optional(quantity->value) : to_si(*quantity, dimension);
        if (value && std::isfinite(*value) && *value > 0.0) {
            const std::optional<QuantityLimits> limits = quantity_limits(dimension);
            if (limits && (*value < limits->least || *value > limits->most)) {
                throw InputError(fmt::format("{} {} cannot be meant: {}", option, text, limits->reason));
            }
            return *value;
        }
    }
    throw InputError(
        fmt::format("{} must be {} greater than 0 (units: {}; {} where none is given), but is \"{}\"", option,
                    dimension_name(dimension), unit_list(dimension), si_unit(dimension), text));
}

}  // namespace riffle::inline cli
