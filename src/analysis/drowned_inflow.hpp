#pragma once

#include <string>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// What it means that much deeper water stands at an inflow whose depth the case gives, as the end of a
/// sentence: "where 40 mm enter faster than their waves: ...". The depth is over what the water stands on.
[[nodiscard]] std::string drowned_inflow_text(const Case& c);

/// Where water that is to enter faster than its waves meets much deeper water at the inflow, the depth there,
/// with drowned_inflow_text(). Returns whether that is so.
bool add_drowned_inflow(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
