#pragma once

#include "case/case.hpp"
#include "case/problems.hpp"

namespace riffle {

/// Check what keys demand of each other (each value by itself is right already). `places` tells where the
/// values were given. Files that the case names must exist when `check_files`.
void validate(const Case& c, const Places& places, bool check_files, Problems& problems);

}  // namespace riffle
