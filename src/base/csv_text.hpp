#pragma once

#include <optional>
#include <string>

namespace riffle::inline base {

/// A number as a cell of a CSV file, nine significant digits; empty where there is none or it is not finite.
[[nodiscard]] std::string csv_number(double value);
[[nodiscard]] std::string csv_number(const std::optional<double>& value);

/// A text as a cell of a CSV file: quoted where it holds what separates cells or lines (RFC 4180).
[[nodiscard]] std::string csv_cell(const std::string& text);

}  // namespace riffle::inline base
