#pragma once

#include "case/case.hpp"

namespace riffle::inline ends {

/// The least part of the sections of a duct that solids at rest leave open, 1 where there are none: of
/// sections a spacing apart, by points a spacing apart in two dimensions, a twenty-fourth of height and width
/// in three.
[[nodiscard]] double narrowest_opening(const Case& c);

}  // namespace riffle::inline ends
