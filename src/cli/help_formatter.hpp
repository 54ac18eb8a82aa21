#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace riffle::inline cli {

/// The help of CLI11 with its descriptions broken into lines of 80 columns; the examples and what follows
/// them are printed as they are.
[[nodiscard]] std::shared_ptr<CLI::Formatter> help_formatter();

}  // namespace riffle::inline cli
