#pragma once

#include "sph/pair_loops.hpp"

namespace riffle::inline sph {

/// Largest |h u_ij . r_ij / (r_ij^2 + eta^2)| of all pairs of fluid particles nearer than 2h, eta = 0.1 h,
/// m/s: the velocity of a pair along its line of centres as Monaghan & Kos (1999) take it into the time step
/// (thesis 2.53). From the lists and records of `data`, in double precision and plain code; the same for any
/// number of threads. `smoothing_length` h in m.
template <int D, class Real>
[[nodiscard]] double largest_pair_approach(const PairData<D, Real>& data, const Clusters<D>& clusters,
                                           const FixedPoint<D>& fixed_point, double smoothing_length);

}  // namespace riffle::inline sph
