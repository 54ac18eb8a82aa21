#pragma once

#include <optional>

#include "case/case.hpp"
#include "ends/time_table.hpp"

namespace riffle::inline ends {

/// Times in which the ends of a channel with a free surface bring the flow home, s: those of the case, or
/// what lets waves out and keeps what is given.
struct EndRelaxation {
    double inflow = 0.0;   ///< of the discharge
    double outflow = 0.0;  ///< of the depth that rules the outflow
};

/// `tailwater`: the depth that is held at the outflow, where the case gives one. One that changes is followed
/// by both ends, but for waves that are short for that change: those that a tide sends up the channel and
/// back must not leave.
[[nodiscard]] EndRelaxation end_relaxation(const Case& c, const std::optional<TimeTable>& tailwater);

}  // namespace riffle::inline ends
