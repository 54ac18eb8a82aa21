#pragma once

#include "case/case.hpp"

namespace riffle::inline ends {

/// Time in which the flow between open ends forgets its start, s: the longest of the one in which the
/// discharge replaces all the water (volume of the start over q), the one in which the outflow goes to what
/// rules it there, and that of a wave along the channel. Throws as read_end_levels().
[[nodiscard]] double relaxation_time_between_ends(const Case& c);

}  // namespace riffle::inline ends
