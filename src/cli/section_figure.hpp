#pragma once

#include <string>

#include "case/case.hpp"
#include "column/section.hpp"

namespace riffle::inline cli {

/// A figure of the cross-section as one SVG text: the map of U/U_max over the simulated width with isolines,
/// the profile at the centreline and the depth mean across the channel, the measured depth mean beside it.
[[nodiscard]] std::string section_figure(const Case& c, const SectionResult& result,
                                         const std::string& subtitle);

}  // namespace riffle::inline cli
