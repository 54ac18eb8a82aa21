#pragma once

#include <optional>
#include <string>

#include "case/units.hpp"

namespace riffle::inline cli {

/// Value of a command line's quantity in SI units: "80mm", "0.08 m" or "0.08". Throws InputError naming the
/// option, what was given and what is expected, also for sizes that cannot be meant.
[[nodiscard]] double quantity_argument(const std::string& option, const std::string& text,
                                       Dimension dimension);

}  // namespace riffle::inline cli
