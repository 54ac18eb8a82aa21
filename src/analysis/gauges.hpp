#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// Figure and findings of the pressure gauges: running means over 3 ms, the time that a laboratory's gauge
/// takes to follow a blow, and the largest of each gauge beside its largest sample. Nothing where no gauge
/// recorded anything.
void add_gauges(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
