#pragma once

#include <vector>

#include "particles/working_values.hpp"

namespace riffle::test {

/// Values by particle as a step keeps them in double precision.
inline WorkingValues working(const std::vector<double>& values) {
    WorkingValues result;
    result.reset<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) result.set(i, values[i]);
    return result;
}

}  // namespace riffle::test
