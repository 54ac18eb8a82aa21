#pragma once

#include "case/case.hpp"

namespace riffle::inline sph {

/// Sum of V W over all places of the lattice of a case's start without end, at one of them: what the kernel
/// sums to in water that the particles fill evenly, 1 but for some thousandths.
template <int D>
[[nodiscard]] double lattice_kernel_sum(const Case& c);

}  // namespace riffle::inline sph
