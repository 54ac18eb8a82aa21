#pragma once

#include "case/case.hpp"

namespace riffle {

/// The numerics of a preset, before any key of the case changes them. In three dimensions the thesis took a
/// lower speed of sound than in two.
[[nodiscard]] Numerics preset_numerics(Preset preset, int dimensions = 2);

}  // namespace riffle
