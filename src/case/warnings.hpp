#pragma once

#include "case/case_check.hpp"

namespace riffle {

/// All that a valid case is warned of, beyond keys that have no effect.
[[nodiscard]] const CheckList& warnings();

}  // namespace riffle
