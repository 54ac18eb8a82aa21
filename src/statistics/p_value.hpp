#pragma once

#include <string>

namespace riffle::inline statistics {

/// Smaller chances mean nothing: the tests' distributions are not known so far out, nor are numbers of the
/// computer.
inline constexpr double least_p_value = 1e-16;

/// A p-value with its relation: "= 0.012", or "< 1e-16".
[[nodiscard]] std::string p_value_text(double p);

}  // namespace riffle::inline statistics
