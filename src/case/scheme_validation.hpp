#pragma once

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// What the options of the pair sums demand of each other.
void validate_scheme(const Case& c, const Places& places, Problems& problems);

}  // namespace riffle
