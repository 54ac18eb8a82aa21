#pragma once

#include <memory>

#include "roughness/bed_drag.hpp"

namespace riffle::inline roughness {

/// The drag of a bed where solids at rest lie on parts of it: water above a solid does not meet what is below
/// it. Where none is lower than the drag reaches it is `drag` itself.
[[nodiscard]] std::unique_ptr<const BedDrag> drag_beside_solids(const Case& c,
                                                                std::unique_ptr<const BedDrag> drag);

}  // namespace riffle::inline roughness
