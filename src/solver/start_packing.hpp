#pragma once

#include <vector>

#include "case/case.hpp"
#include "engine/scheme.hpp"
#include "particles/particles.hpp"

namespace riffle {

/// What packing has made of the particles of a start.
struct PackedStart {
    std::vector<double> share;  ///< volume of each particle over that of a place of the lattice
    int iterations = 0;
    double unevenness_before = 0.0;  ///< largest h |sum V grad W| of the particles that may move
    double unevenness_after = 0.0;
};

/// Whether a case asks for a packed start, and has one: that from other results has their particles.
[[nodiscard]] inline bool starts_packed(const Case& c) {
    return c.start.packed && c.start.kind != StartKind::results;
}

/// Move the particles beside solids until they fill the water evenly: each down the gradient of the kernel's
/// sum over water, walls and the places of the lattice above the water (Colagrossi et al. 2012), to where it
/// is 0. Where a face cuts the rows of the lattice, it leaves gaps of up to a spacing, whose water would be
/// too light. With jitter all particles move, else those within eight smoothing lengths of a solid. The
/// volume of each then follows from the kernel's sum. The same for any number of threads.
template <int D>
[[nodiscard]] PackedStart pack_start(const Case& c, const Scheme& scheme, Particles<D>& particles);

}  // namespace riffle
