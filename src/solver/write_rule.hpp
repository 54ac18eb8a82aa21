#pragma once

#include <algorithm>

namespace riffle::inline solver {

/// Wall-clock time from one write of a run to the next, s, when it has run so long and
/// `output.checkpoint_interval` is this: soon at first, so that those who watch see something within seconds;
/// then ever less often.
[[nodiscard]] inline double wait_for_write(double elapsed, double checkpoint_interval) {
    constexpr double first_write = 2.0;
    return std::min(checkpoint_interval, std::max(first_write, 0.5 * elapsed));
}

}  // namespace riffle::inline solver
