#pragma once

#include <vector>

#include "case/case.hpp"
#include "hydraulics/varied_reaches.hpp"

namespace riffle::inline column {

/// The reaches of a channel of a length (m) whose bed changes along it, with the friction of the twins over
/// each bed (twin_channel()): patches that cover the width, strips of plane beds between side walls with what
/// lies beside them, and between them the bed of the channel; behind the end of the case its last bed goes
/// on. Throws InputError where the flow over strips has no twin of the cross-section, at a patch with an
/// outline, where nothing resists the flow over one of the beds, and as twin_channel().
[[nodiscard]] std::vector<Reach> twin_reaches(const Case& c, double unit_discharge, double length);

}  // namespace riffle::inline column
