#pragma once

#include <string>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// The complete normalised TOML text of a case: every key with its value in SI. Reading it gives an equal
/// case.
[[nodiscard]] std::string case_text(const Case& c);

}  // namespace riffle::inline case_file
