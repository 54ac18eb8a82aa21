#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "case/case.hpp"

namespace riffle::inline case_file {

// Where patches lie in plan: parts of a channel with `x_from`, `x_to`, `y_from` and `y_to`, each unset where
// the patch reaches to the end or side of the channel.

/// Whether a patch covers the channel from end to end.
template <class Patch>
[[nodiscard]] bool covers_length(const Case& c, const Patch& patch) {
    return patch.x_from.value_or(0.0) <= 0.0 && patch.x_to.value_or(c.channel.length) >= c.channel.length;
}

/// Whether it covers the channel from side to side.
template <class Patch>
[[nodiscard]] bool covers_width(const Case& c, const Patch& patch) {
    const double width = c.channel.simulated_width();
    return c.channel.dimensions == 2 ||
           (patch.y_from.value_or(0.0) <= 0.0 && patch.y_to.value_or(width) >= width);
}

/// A range of a patch along an axis, m.
struct PatchRange {
    double from = 0.0;
    double to = 0.0;

    [[nodiscard]] double overlap(const PatchRange& other) const {
        return std::min(to, other.to) - std::max(from, other.from);
    }
};

/// The ranges of a patch along the channel and across it.
template <class Patch>
[[nodiscard]] std::array<PatchRange, 2> ranges_of(const Case& c, const Patch& patch) {
    return {{{patch.x_from.value_or(0.0), patch.x_to.value_or(c.channel.length)},
             {patch.y_from.value_or(0.0), patch.y_to.value_or(c.channel.simulated_width())}}};
}

/// Whether two patches lie over each other; the ends of a step of rounding may.
template <class Patch, class Other>
[[nodiscard]] bool lie_over_each_other(const Case& c, const Patch& patch, const Other& other) {
    const auto here = ranges_of(c, patch);
    const auto there = ranges_of(c, other);
    constexpr double rounding = 1e-9;  // m
    return here[0].overlap(there[0]) > rounding &&
           (c.channel.dimensions == 2 || here[1].overlap(there[1]) > rounding);
}

/// The smaller of the extents of a patch in plan, m.
template <class Patch>
[[nodiscard]] double least_extent(const Case& c, const Patch& patch) {
    const auto ranges = ranges_of(c, patch);
    const double along = ranges[0].to - ranges[0].from;
    return c.channel.dimensions == 3 ? std::min(along, ranges[1].to - ranges[1].from) : along;
}

}  // namespace riffle::inline case_file
