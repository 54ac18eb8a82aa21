#pragma once

#include <optional>

#include "case/case.hpp"

namespace riffle::inline column {

/// The case whose section a run with the SPS closure starts from where start.kind = "section": the same with
/// the closure of Czernuszenko & Rylov. None where the case has a section of its own, or starts otherwise.
/// With the SPS closure there is none: the walls' layers must carry a set share of the weight, which the
/// stress of its constant length cannot bring to them, and they come to rest beside a flow of several m/s.
[[nodiscard]] std::optional<Case> section_start_substitute(const Case& c);

}  // namespace riffle::inline column
