#pragma once

#include <functional>
#include <vector>

#include "case/solid_mesh.hpp"
#include "preview/svg_sheet.hpp"

namespace riffle {

/// A stretch of a line that lies in a solid, m.
struct SolidStretch {
    double low = 0.0;
    double high = 0.0;
};

/// The stretches of the upright line at (x, y) that lie in a closed surface, from below upward.
[[nodiscard]] std::vector<SolidStretch> upright_stretches(const SolidMesh& mesh, double x, double y);

/// The polygons that stretches of upright lines at places from `from` to `to` fill: what an upright plane
/// cuts out of a solid. `at`: the stretches at a place along it; looked at `count` places, and where their
/// number changes as closely as doubles allow.
[[nodiscard]] std::vector<std::vector<SheetPoint>> slice_polygons(
    double from, double to, int count, const std::function<std::vector<SolidStretch>(double)>& at);

}  // namespace riffle
