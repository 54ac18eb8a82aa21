#pragma once

#include <CLI/CLI.hpp>

namespace riffle::inline cli {

/// Check of an option's value: a finite number greater than 0.
[[nodiscard]] CLI::Validator positive_number();

}  // namespace riffle::inline cli
