#pragma once

#include <vector>

#include "case/case.hpp"
#include "engine/scheme.hpp"
#include "particles/particles.hpp"

namespace riffle::inline solver {

/// What packing has made of the particles of a start.
struct PackedStart {
    /// Volume of each particle over that of a place of the lattice; empty where nothing moved.
    std::vector<double> share;
    int iterations = 0;
    double unevenness_before = 0.0;  ///< largest h |sum V grad W| of the particles that may move
    double unevenness_after = 0.0;
};

/// Move the particles beside solids until they fill the water evenly: each down the gradient of the kernel's
/// sum over water, walls and the places of the lattice above the water (Colagrossi et al. 2012), to where it
/// is 0. Where a face cuts the rows of the lattice, it leaves gaps of up to a spacing, whose water would be
/// too light. With jitter all particles move, else those within eight smoothing lengths of a solid. The
/// volume of each then follows from the kernel's sum. Unless the case asks for a packed start, nothing moves
/// where the lattice is even already. The same for any number of threads.
template <int D>
[[nodiscard]] PackedStart pack_start(const Case& c, const Scheme& scheme, Particles<D>& particles);

}  // namespace riffle::inline solver
