#pragma once

#include <functional>
#include <vector>

#include "case/solid_stretches.hpp"
#include "preview/svg_sheet.hpp"

namespace riffle::inline preview {

/// The polygons that stretches of upright lines at places from `from` to `to` fill: what an upright plane
/// cuts out of a solid. `at`: the stretches at a place along it; looked at `count` places, and where their
/// number changes as closely as doubles allow.
[[nodiscard]] std::vector<std::vector<SheetPoint>> slice_polygons(
    double from, double to, int count, const std::function<std::vector<SolidStretch>(double)>& at);

}  // namespace riffle::inline preview
