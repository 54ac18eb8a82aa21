#pragma once

#include "sph/pair_loops.hpp"

namespace riffle::inline sph {

/// Number of directed pairs: for each fluid particle the particles, fluid and wall, within `support` (m) of
/// it, without itself. From the lists and records of `data`, in double precision, for measurements.
template <int D, class Real>
[[nodiscard]] double count_directed_pairs(const PairData<D, Real>& data, const Clusters<D>& clusters,
                                          const FixedPoint<D>& fixed_point, double support);

}  // namespace riffle::inline sph
