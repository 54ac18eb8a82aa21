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

/// A sphere of twelve spacings in its water, its middle at no place of the lattice.
inline Solid sphere_in_reach() {
    Solid s;
    s.shape = SolidShape::sphere;
    s.centre = {0.0311, 0.0297, 0.0203};
    s.diameter = 0.024;
    return s;
}

}  // namespace riffle::test
