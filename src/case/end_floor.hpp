#pragma once

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Height of the top of the solid that stands on the bed at a place along a channel, m: 0 where none does,
/// and in three dimensions.
[[nodiscard]] double floor_at(const Case& c, double x);

/// Heights on which the water of open ends stands, m: of the bed, 0, or of a solid that reaches through the
/// end.
struct EndFloors {
    double upstream = 0.0;
    double downstream = 0.0;
};
[[nodiscard]] EndFloors end_floors(const Case& c);

/// Depth at an end, of all the water over what it stands on at `floor`, from a level over the datum, m.
[[nodiscard]] inline double over_floor(const Case& c, double level, double floor) {
    return level + c.datum() - floor;
}

/// Whether a solid carries the water through an open end: it reaches through all that stands beyond the end
/// and all that is watched before it, with a level top. `from`, `to`: that stretch of the channel, m.
[[nodiscard]] bool carries_through(const Solid& solid, double from, double to);

/// Whether a solid in two dimensions that stands still lies under all of a channel between periodic ends: it
/// reaches beyond both by more than its layers of wall particles are thick, and at the same heights there as
/// in the channel.
[[nodiscard]] bool passes_through(const Case& c, const Solid& solid);

}  // namespace riffle::inline case_file
