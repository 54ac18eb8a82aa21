#pragma once

#include <optional>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "case/case.hpp"
#include "case/outline.hpp"

namespace riffle::inline analysis {

/// Outlines of the solids of a case in two dimensions, where they stand at a time (s), free bodies where they
/// start. Empty in three.
[[nodiscard]] std::vector<Outline> outlines_at(const Case& c, double time);

/// The same without free bodies, whose place no law says.
[[nodiscard]] std::vector<Outline> prescribed_outlines_at(const Case& c, double time);

/// These as filled curves of a figure whose axes are x and the height above the bed level, and the free
/// bodies where an instrument has recorded them at another time, s.
[[nodiscard]] std::vector<Curve> body_curves(const FlowRecord& record, double time, double time_of_free);

/// Length of the upright line at x that lies in solids, from the bed level up to a height, m.
[[nodiscard]] double blocked_height(const std::vector<Outline>& outlines, double x, double up_to);

/// A body of water at rest behind a dam that is gone at once, or a gate that is pulled: a rectangle that
/// leans on one end of a closed channel with a dry, level bed before it.
struct DamBreak {
    double dam = 0;       ///< place of the dam, m
    double depth = 0;     ///< h0, m
    double length = 0;    ///< of the reservoir, m
    double opening = 0;   ///< time at which the water is free, s
    bool forward = true;  ///< the water runs towards larger x
};

/// The dam break that the case is; nothing where it is none.
[[nodiscard]] std::optional<DamBreak> dam_break_of(const Case& c);

}  // namespace riffle::inline analysis
