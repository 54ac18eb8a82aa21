#pragma once

#include <functional>
#include <optional>

#include "case/case.hpp"
#include "case/outline.hpp"
#include "case/solid_stretches.hpp"

namespace riffle::inline case_file {

/// From where to where a solid reaches, where it stands at the start, over a place in plan, m: from its
/// lowest point there to its highest. As solid_top().
[[nodiscard]] std::optional<SolidStretch> solid_extent(const Case& c, const Solid& solid, double x, double y);

/// Height of the top of a solid, where it stands at the start, over a place in plan, m; in two dimensions y
/// does not count. Nothing where none of it lies, and of a solid in space whose surface was not read.
[[nodiscard]] std::optional<double> solid_top(const Case& c, const Solid& solid, double x, double y);

/// Height at which the stems of a patch stand at a place in plan, m: the top of the solid that they stand on,
/// the bed level beside it and without one.
[[nodiscard]] double stem_foot(const Case& c, const Vegetation& stems, double x, double y);

/// What the stems of a patch fill in an upright view from one place to another, m: along the ground and back
/// along their tops. `foot`: the height at which they stand at a place.
[[nodiscard]] Outline canopy_outline(const Vegetation& stems, double from, double to,
                                     const std::function<double(double)>& foot);

}  // namespace riffle::inline case_file
