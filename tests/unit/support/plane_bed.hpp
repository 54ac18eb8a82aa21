#pragma once

#include "case/case.hpp"

namespace riffle::test {

/// A plane bed of an equivalent roughness, m, in place of the spheres; 0: a smooth one.
inline void lay_plane_bed(Case& c, double roughness) {
    c.bed.kind = roughness > 0.0 ? BedKind::roughness : BedKind::smooth;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    if (roughness > 0.0) c.bed.equivalent_roughness = roughness;
}

}  // namespace riffle::test
