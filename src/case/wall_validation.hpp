#pragma once

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// Add to `problems` what the kind of the walls of a case does not go with.
void validate_walls(const Case& c, const Places& places, Problems& problems);

}  // namespace riffle
