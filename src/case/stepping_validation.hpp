#pragma once

#include "case/problems.hpp"

namespace riffle {

struct Case;

/// Combinations of time stepping and particle regularity that make no sense.
void validate_stepping(const Case& c, const Places& places, Problems& problems);

}  // namespace riffle
