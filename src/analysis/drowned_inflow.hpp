#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// Where water that is to enter faster than its waves meets much deeper water at the inflow, the depth there,
/// with what it means. Returns whether that is so.
bool add_drowned_inflow(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
