#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace riffle::inline cli {

/// A number for a table of the terminal: four significant digits, more than any of the measurements has.
[[nodiscard]] std::string printed_number(double value);

/// A number in JSON, null where there is none.
[[nodiscard]] nlohmann::ordered_json optional_number(const std::optional<double>& value);

}  // namespace riffle::inline cli
