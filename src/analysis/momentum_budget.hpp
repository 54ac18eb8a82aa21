#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// Findings of a channel with open ends: the momentum that the water brings in and takes out, the pressure on
/// the sections of both ends, the weight down the slope, and what bed, walls and each body take of it, the
/// bodies by pressure (form drag) and by friction; last what of it does not close. Means over the window.
/// Nothing of other channels, whose forces stand over the weight component (chapter_forces.cpp).
void add_momentum_budget(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
