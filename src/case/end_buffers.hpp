#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline case_file {

// The water beyond the ends of an open channel: buffers of ordinary particles whose motion the ends
// prescribe.

/// Way that water may go at an end from one list build to the next, m: particles are made and taken out at
/// list builds.
[[nodiscard]] inline double end_travel(const Case& c) { return 2.0 * c.numerics.spacing; }

/// Water that must stand beyond an end, m: what the kernels of the channel reach, with all that these
/// particles' own sums need.
[[nodiscard]] inline double end_support(const Case& c) {
    return 4.0 * c.numerics.smoothing_ratio * c.numerics.spacing;
}

/// Sections between which water takes all of its momentum from its own forces, m along the channel: a
/// kernel's support inside the ends, up to where a section's sums reach no water whose motion an end
/// prescribes.
[[nodiscard]] inline std::array<double, 2> momentum_sections(const Case& c) {
    const double support = 0.5 * end_support(c);
    return {support, c.channel.length - support};
}

/// The standard instrument at these sections.
inline constexpr const char* momentum_sections_name = "standard_momentum_sections";

/// Least share of the depth over which the water beside an end is watched. The section takes over what the
/// water there presses; where it is watched so near that it can do nothing but follow the section, nothing
/// holds the two (docs/theory.md 20).
inline constexpr double least_watched_share = 0.25;

/// Whole spacings in half of the stretch beside each open end over which the water is watched: of two kernel
/// supports and, under a free surface, of a share of the deepest water that the keys name.
[[nodiscard]] inline double watched_spacings(const Case& c) {
    const double deepest = is_duct(c) ? 0.0 : std::max(c.total_depth(), highest_end_level(c));
    return std::ceil(
        std::max(2.0 * c.numerics.smoothing_ratio, 0.5 * least_watched_share * deepest / c.numerics.spacing) -
        1e-9);
}

/// That stretch, which solids must leave free, m.
[[nodiscard]] inline double watched_stretch(const Case& c) {
    return 2.0 * watched_spacings(c) * c.numerics.spacing;
}

/// Longest that a buffer becomes, m; 0 where the ends are not open.
[[nodiscard]] inline double buffer_length(const Case& c) {
    return c.channel.ends == Ends::open ? end_support(c) + end_travel(c) + c.numerics.spacing : 0.0;
}

/// How far beyond an open end walls stand, m: below and beside its buffer, with the layers behind it.
[[nodiscard]] inline double walls_beyond_end(const Case& c) {
    return buffer_length(c) + c.numerics.wall_layers * c.numerics.spacing;
}

/// Whether a place along the channel is in it: what stands beyond an open end counts in no mean.
[[nodiscard]] inline bool in_channel(const Case& c, double x) {
    return c.channel.ends != Ends::open || (x >= 0.0 && x < c.channel.length);
}

}  // namespace riffle::inline case_file
