#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// Findings for each resting body that a stream flows around: its drag and lift coefficient with the bulk
/// velocity of the stream and its area as seen along the channel, and the Strouhal number where vortices
/// shed in a rhythm swing it. Nothing of bodies that stand on the bed across the whole channel: weirs, steps,
/// beds.
void add_body_coefficients(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
