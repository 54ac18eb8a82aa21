#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// Figures and findings of a flood that passes the sections of the instruments: the largest discharge and
/// depth of each, when they pass, how much the crest lags behind the one at the inflow and is less, the loop
/// of the rating, and the highest level recorded anywhere. Nothing without a hydrograph.
void add_flood_passage(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
