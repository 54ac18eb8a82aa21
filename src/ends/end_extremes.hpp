#pragma once

#include "case/case.hpp"
#include "ends/end_input.hpp"

namespace riffle::inline ends {

/// Largest total depth (m) and largest velocity (m/s) that the case gives at its ends or its start, by all
/// rows of its tables, for a run may be prolonged: they choose the speed of sound.
struct EndExtremes {
    double depth = 0.0;
    double velocity = 0.0;
};
[[nodiscard]] EndExtremes end_extremes(const Case& c, const EndInput& input);

}  // namespace riffle::inline ends
