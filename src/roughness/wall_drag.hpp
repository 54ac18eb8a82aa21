#pragma once

#include <memory>

#include "roughness/bed_drag.hpp"

namespace riffle::inline roughness {

/// The friction of a bed by a wall law as particles in rows of a height (m) meet it: the drag of their wall
/// layer (turbulence/wall_layer.hpp). nullptr where the case's bed has no wall law.
[[nodiscard]] std::unique_ptr<const BedDrag> make_wall_drag(const Case& c, double row_height);

}  // namespace riffle::inline roughness
