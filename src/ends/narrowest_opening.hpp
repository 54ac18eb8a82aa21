#pragma once

#include "case/case.hpp"

namespace riffle::inline ends {

/// The least part of the sections of a duct that solids at rest leave open, 1 where there are none: by points
/// a spacing apart, but at least 24 and at most 64 over the height, over the width, and at most 64 sections
/// of a solid.
[[nodiscard]] double narrowest_opening(const Case& c);

}  // namespace riffle::inline ends
