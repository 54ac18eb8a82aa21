#pragma once

#include "case/case.hpp"

namespace riffle::test {

/// A reach of 60 by 60 by 40 mm over a frictionless bed, periodic along and across, particles 2 mm apart.
inline Case periodic_reach() {
    Case c;
    c.channel.dimensions = 3;
    c.channel.sides = Sides::periodic;
    c.bed.kind = BedKind::slip;
    c.bed.datum_below_crest = 0.0;
    c.channel.depth = 0.04;
    c.channel.length = 0.06;
    c.channel.width = 0.06;
    c.numerics.spacing = 0.002;
    return c;
}

}  // namespace riffle::test
