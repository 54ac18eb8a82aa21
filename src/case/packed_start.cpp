#include "case/packed_start.hpp"

#include <algorithm>

#include "case/key_table.hpp"
#include "case/outline_check.hpp"

namespace riffle::inline case_file {

bool packing_meets_entering_rows(const Case& c) {
    return c.channel.ends == Ends::open && c.channel.top != Top::wall;
}

bool packing_reaches_an_open_end(const Case& c) {
    // Packing moves the water within eight smoothing lengths of solids, and what it is pressed against lies
    // two beyond.
    const double clear = 10.0 * c.numerics.smoothing_ratio * c.numerics.spacing;
    const auto near = [&](const Solid& solid) {
        const auto extent = extent_of(c, solid, 0);
        return extent && (extent->low < clear || extent->high > c.channel.length - clear);
    };
    return c.channel.ends == Ends::open && std::any_of(c.solids.begin(), c.solids.end(), near);
}

bool packing_lacks_wall_layers(const Case& c) {
    const bool layers = c.numerics.wall == WallKind::dummy || c.numerics.wall == WallKind::modified_dynamic;
    return c.channel.top == Top::periodic || !layers;
}

bool starts_packed(const Case& c) {
    if (c.start.kind == StartKind::results || !key_applies(*find_key("start.packed"), c)) return false;
    if (c.start.packed) return *c.start.packed;
    return c.channel.dimensions == 2 && !c.solids.empty() && c.start.jitter == 0.0 &&
           !packing_lacks_wall_layers(c) && !packing_meets_entering_rows(c) &&
           !packing_reaches_an_open_end(c);
}

}  // namespace riffle::inline case_file
