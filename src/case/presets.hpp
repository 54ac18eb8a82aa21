#pragma once

#include "case/case.hpp"

namespace riffle {

/// The [numerics] section of a preset: the defaults of the keys that a case does not give.
[[nodiscard]] Numerics preset_numerics(Preset preset);

}  // namespace riffle
