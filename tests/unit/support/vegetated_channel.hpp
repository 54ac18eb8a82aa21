#pragma once

#include "case/case.hpp"

namespace riffle::test {

/// A wide channel over a slip bed, which only what stands in the water holds back.
inline Case slip_channel(double slope, double depth) {
    Case c;
    c.channel.slope = slope;
    c.channel.depth = depth;
    c.channel.length = 0.5;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.turbulence.closure = ClosureKind::nezu_rodi;
    return c;
}

/// Stems of a constant drag coefficient all over a channel.
inline Vegetation stems(double per_area, double diameter, double height, double drag_coefficient) {
    Vegetation stems;
    stems.name = "reeds";
    stems.stems_per_area = per_area;
    stems.stem_diameter = diameter;
    stems.height = height;
    stems.drag_coefficient = drag_coefficient;
    return stems;
}

}  // namespace riffle::test
