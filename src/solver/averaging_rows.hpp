#pragma once

#include "case/case.hpp"

namespace riffle::inline solver {

/// How many rows of the start's lattice the layers of profiles and the cells of mean fields are stacked in:
/// those of the start, and where the level varies along the channel as many as it has room for.
[[nodiscard]] int averaging_rows(const Case& c);

}  // namespace riffle::inline solver
