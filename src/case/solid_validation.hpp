#pragma once

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// Check what a case says of walls and bodies beyond the plain channel: the outline of the water at the
/// start, the height of the end walls, the lid's velocity and the [[solid]] entries.
void validate_solids(const Case& c, const Places& places, Problems& problems);

}  // namespace riffle
