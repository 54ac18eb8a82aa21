#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// Figures and findings of a tailwater that changes by a file, as a tide or a reservoir that is drawn down:
/// at each section of the instruments the highest and the lowest water, how much of the outflow's range
/// arrives there and how late, and the largest and the smallest discharge, which is less than zero where the
/// flow turns. Nothing where no file tells the depth at the outflow.
void add_tailwater_passage(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
