#pragma once

#include <cstddef>
#include <functional>

#include "particles/domain.hpp"

namespace riffle::inline boundary {

/// Told of water that a solid has put back: which solid, at which of its places, m, and what was added to the
/// water's velocity, m/s.
using Push = std::function<void(std::size_t solid, const Vec<3>& place, const Vec<3>& gain)>;

}  // namespace riffle::inline boundary
