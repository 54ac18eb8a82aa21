#pragma once

#include <vector>

#include "case/case.hpp"

namespace riffle::inline sph {

/// Sum of V W over all places of the lattice of a case's start without end, at one of them: what the kernel
/// sums to in water that the particles fill evenly, 1 but for some thousandths.
template <int D>
[[nodiscard]] double lattice_kernel_sum(const Case& c);

/// What the kernel finds in a row of particles of that lattice under a level surface.
struct SurfaceRow {
    double fill = 1.0;  ///< sum of V W over lattice_kernel_sum()
    double lean = 0.0;  ///< length of the sum of V W r over that and h: 0 where the water is on all sides
};

/// Of the rows from the uppermost one down to the first that sees nothing of the surface.
template <int D>
[[nodiscard]] std::vector<SurfaceRow> lattice_surface_rows(const Case& c);

}  // namespace riffle::inline sph
