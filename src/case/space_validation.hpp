#pragma once

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// The checks of what belongs to three dimensions, and of what does not exist in them yet; adds a message for
/// each that fails, at the place of its keys.
void validate_space(const Case& c, const Places& places, Problems& problems);

/// The checks of what the snapshots hold.
void validate_snapshots(const Case& c, const Places& places, Problems& problems);

}  // namespace riffle
