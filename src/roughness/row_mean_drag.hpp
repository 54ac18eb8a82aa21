#pragma once

#include <memory>

#include "roughness/bed_drag.hpp"

namespace riffle::inline roughness {

/// A drag as particles meet it that stand for rows of a height: its mean over the row of each particle, from
/// z - row_height/2 to z + row_height/2 (theory 8). The sum of it over the rows of a layered flow is that of
/// the whole bed wherever the rows stand.
[[nodiscard]] std::unique_ptr<const BedDrag> row_mean_drag(std::unique_ptr<const BedDrag> drag,
                                                           double row_height);

}  // namespace riffle::inline roughness
