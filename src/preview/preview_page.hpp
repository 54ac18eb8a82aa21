#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "solver/forecast.hpp"

namespace riffle::inline preview {

/// The geometry of a case as one drawing (SVG): side view, in three dimensions plan and cross-sections, and
/// the particles of a part of it.
[[nodiscard]] std::string preview_drawing(const Case& c);

/// A page with that drawing, the numbers of the forecast (unless it is null), solids, instruments and
/// warnings.
[[nodiscard]] std::string preview_page(const Case& c, const std::string& drawing, const Forecast* forecast,
                                       const std::vector<std::string>& warnings);

}  // namespace riffle::inline preview
