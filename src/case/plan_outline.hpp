#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "case/outline.hpp"

namespace riffle::inline case_file {

// Outlines of patches in plan: `x` of an Outline along the channel, its `z` across it (y).

/// A range of a patch along an axis, m.
struct PatchRange {
    double from = 0.0;
    double to = 0.0;

    [[nodiscard]] double size() const { return to - from; }
    [[nodiscard]] double overlap(const PatchRange& other) const {
        return std::min(to, other.to) - std::max(from, other.from);
    }
};

/// A rectangle along the axes.
[[nodiscard]] Outline rectangle_in_plan(const PatchRange& along, const PatchRange& across);

/// The stretches of a line that lie in an outline, in their order: of the line along an axis (0: x, 1: y)
/// through a place on the other axis, m.
[[nodiscard]] std::vector<PatchRange> chords(const Outline& outline, std::size_t axis, double place);

/// The least width of an outline at right angles to one of its edges, m.
[[nodiscard]] double least_width(const Outline& outline);

/// The thickness of an outline behind the middles of its edges, m: half of its length has no more. Of a band
/// that turns, its width.
[[nodiscard]] double usual_thickness(const Outline& outline);

/// The area that lies in both of two outlines, m2.
[[nodiscard]] double common_area(const Outline& one, const Outline& other);

/// The area of an outline that lies in a rectangle, m2. Faster than common_area().
[[nodiscard]] double area_in_rectangle(const Outline& outline, const PatchRange& along,
                                       const PatchRange& across);

}  // namespace riffle::inline case_file
