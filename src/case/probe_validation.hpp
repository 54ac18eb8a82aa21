#pragma once

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// Check the [[probe]] entries of a case against each other and against its channel. What only the time step
/// decides is checked where that is known (instruments/probe_set.hpp).
void validate_probes(const Case& c, const Places& places, Problems& problems);

}  // namespace riffle
