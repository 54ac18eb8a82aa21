#pragma once

#include <vector>

#include "analysis/along_parts.hpp"
#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// The water between two bodies that close most of a channel, as the weirs of a fish pass do.
struct Pool {
    double from = 0.0;    ///< m along the channel; beyond its length where the pool reaches over its end
    double to = 0.0;      ///< m
    double level = 0.0;   ///< mean of its surface over the bed level, m
    double head = 0.0;    ///< height of its surface over a level datum, that of the bed at x = 0, m
    double fall = 0.0;    ///< of the water that comes into it, from the pool before, m of head
    double volume = 0.0;  ///< of its water, of a unit of the channel's width, m2

    [[nodiscard]] double middle() const { return 0.5 * (from + to); }
};

/// The pools of a channel from one body to the next that closes at least half of the section of the water
/// there; a reach shorter than half its depth is none. In a channel with open ends only those between two
/// such bodies; in a periodic one each follows the other. \param profile mean levels over all of the channel,
/// by equal steps
[[nodiscard]] std::vector<Pool> pools_of(const Case& c, const LongProfile& profile);

/// What a fish pass is designed by: the drop from pool to pool, the velocity of a jet that has fallen so far,
/// and the power that each pool takes from the water, over its volume (FAO/DVWK 2002).
/// \param unit_discharge steady, m2/s
void add_pools(const FlowRecord& record, const LongProfile& profile, double unit_discharge,
               Analysis& analysis);

}  // namespace riffle::inline analysis
