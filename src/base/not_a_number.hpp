#pragma once

#include <limits>

namespace riffle::inline base {

/// Stands where a quantity has no value: figures leave a gap there, tables an empty cell.
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace riffle::inline base
