#pragma once

#include "case/case.hpp"

namespace riffle::test {

/// Closed tank with a smooth frictionless bed, 2 mm between particles; lengths in m.
inline Case smooth_tank(double depth, double length) {
    Case c;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.channel.slope = 0.0;
    c.channel.depth = depth;
    c.channel.length = length;
    c.channel.ends = Ends::walls;
    c.numerics.spacing = 0.002;
    return c;
}

}  // namespace riffle::test
