#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "case/case.hpp"
#include "case/plan_outline.hpp"

namespace riffle::inline case_file {

// Where patches lie in plan: parts of a channel with `x_from`, `x_to`, `y_from` and `y_to`, each unset where
// the patch reaches to the end or side of the channel, or in three dimensions with an outline, `x` and `y`.

/// Whether a patch has an outline.
template <class Patch>
[[nodiscard]] bool is_outlined(const Patch& patch) {
    return !patch.x.empty() && !patch.y.empty();
}

/// What an outlined patch covers in plan. A corner without its other half, which is refused, does not count.
template <class Patch>
[[nodiscard]] Outline outline_of(const Patch& patch) {
    Outline outline{patch.x, patch.y};
    outline.x.resize(std::min(patch.x.size(), patch.y.size()));
    outline.z.resize(outline.x.size());
    return outline;
}

/// Whether the outline of a patch is all of the channel's plan.
template <class Patch>
[[nodiscard]] bool outlines_all(const Case& c, const Patch& patch) {
    const double length = c.channel.length;
    const double width = c.channel.simulated_width();
    return area_in_rectangle(outline_of(patch), {0.0, length}, {0.0, width}) >= (1.0 - 1e-9) * length * width;
}

/// Whether a patch covers the channel from end to end.
template <class Patch>
[[nodiscard]] bool covers_length(const Case& c, const Patch& patch) {
    if (is_outlined(patch)) return outlines_all(c, patch);
    return patch.x_from.value_or(0.0) <= 0.0 && patch.x_to.value_or(c.channel.length) >= c.channel.length;
}

/// Whether it covers the channel from side to side.
template <class Patch>
[[nodiscard]] bool covers_width(const Case& c, const Patch& patch) {
    const double width = c.channel.simulated_width();
    if (is_outlined(patch)) return outlines_all(c, patch);
    return c.channel.dimensions == 2 ||
           (patch.y_from.value_or(0.0) <= 0.0 && patch.y_to.value_or(width) >= width);
}

/// The ranges of a patch along the channel and across it; of one with an outline those that it reaches over.
template <class Patch>
[[nodiscard]] std::array<PatchRange, 2> ranges_of(const Case& c, const Patch& patch) {
    if (is_outlined(patch)) {
        const auto [x_least, x_most] = std::minmax_element(patch.x.begin(), patch.x.end());
        const auto [y_least, y_most] = std::minmax_element(patch.y.begin(), patch.y.end());
        return {{{*x_least, *x_most}, {*y_least, *y_most}}};
    }
    return {{{patch.x_from.value_or(0.0), patch.x_to.value_or(c.channel.length)},
             {patch.y_from.value_or(0.0), patch.y_to.value_or(c.channel.simulated_width())}}};
}

/// What a patch covers in plan.
template <class Patch>
[[nodiscard]] Outline plan_outline(const Case& c, const Patch& patch) {
    if (!is_outlined(patch)) {
        const auto [along, across] = ranges_of(c, patch);
        return rectangle_in_plan(along, across);
    }
    return outline_of(patch);
}

/// The stretches that a patch covers of a line along an axis (0: x, 1: y) through a place on the other axis,
/// m. In two dimensions a line along the channel goes through it whatever the place.
template <class Patch>
[[nodiscard]] std::vector<PatchRange> stretches_of(const Case& c, const Patch& patch, std::size_t axis,
                                                   double place) {
    if (is_outlined(patch)) return chords(plan_outline(c, patch), axis, place);
    const auto ranges = ranges_of(c, patch);
    const PatchRange& beside = ranges[1 - axis];
    const bool cut = (axis == 0 && c.channel.dimensions == 2) || (place >= beside.from && place <= beside.to);
    return cut ? std::vector{ranges[axis]} : std::vector<PatchRange>{};
}

/// Whether two patches lie over each other; the ends of a step of rounding may.
template <class Patch, class Other>
[[nodiscard]] bool lie_over_each_other(const Case& c, const Patch& patch, const Other& other) {
    const auto here = ranges_of(c, patch);
    const auto there = ranges_of(c, other);
    constexpr double rounding = 1e-9;  // m
    const bool ranges_meet = here[0].overlap(there[0]) > rounding &&
                             (c.channel.dimensions == 2 || here[1].overlap(there[1]) > rounding);
    if (!ranges_meet || (!is_outlined(patch) && !is_outlined(other))) return ranges_meet;
    return common_area(plan_outline(c, patch), plan_outline(c, other)) > rounding * c.channel.length;
}

/// The smaller of the extents of a patch in plan, m; of an outline its area over its larger extent, its least
/// width at right angles to one of its edges, or its usual thickness.
template <class Patch>
[[nodiscard]] double least_extent(const Case& c, const Patch& patch) {
    const auto ranges = ranges_of(c, patch);
    const double along = ranges[0].to - ranges[0].from;
    const double across = ranges[1].to - ranges[1].from;
    if (is_outlined(patch)) {
        const Outline outline = outline_of(patch);
        return std::min({std::abs(signed_area(outline)) / std::max(along, across), least_width(outline),
                         usual_thickness(outline)});
    }
    return c.channel.dimensions == 3 ? std::min(along, across) : along;
}

}  // namespace riffle::inline case_file
