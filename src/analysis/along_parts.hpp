#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

// Parts of the chapter along the channel.

/// Time means of the level along a line, by columns in the order of x. Not-a-number where it was dry.
struct LongProfile {
    std::vector<double> x, level, half_width, lowest, highest;  ///< m, heights above the bed level
    std::vector<bool> covered;                                  ///< Whether a body lies on the water.

    [[nodiscard]] bool covered_somewhere() const {
        return std::find(covered.begin(), covered.end(), true) != covered.end();
    }
};

/// Of a record of the surface; `covered` stays empty.
[[nodiscard]] LongProfile long_profile(const SpaceTime& surface);

/// The discharge through the section at the inflow, else through the first section that records it, in steady
/// flow that of all, m3/s (2D: m2/s); empty where none does.
[[nodiscard]] std::vector<double> discharge_of(const FlowRecord& record);

/// Discharge per unit width.
struct UnitDischarge {
    double mean = 0.0;                 ///< m2/s
    std::optional<double> half_width;  ///< of the 95 % interval, where there is one that can be trusted
    /// Its change over the window over its mean, where the flow is to be steady and that is more than chance,
    /// than the interval and than the case's tolerance; there is no interval then, for that of a mean that
    /// drifts says nothing of where it goes. A smaller change widens the interval to itself.
    double drift = 0.0;
};

/// Of discharge_of(); nothing where no section records one.
[[nodiscard]] std::optional<UnitDischarge> unit_discharge(const FlowRecord& record);

}  // namespace riffle::inline analysis
