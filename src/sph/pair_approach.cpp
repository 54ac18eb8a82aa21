#include "sph/pair_approach.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "sph/listed_pairs.hpp"

namespace riffle::inline sph {

template <int D, class Real>
double largest_pair_approach(const PairData<D, Real>& data, const Clusters<D>& clusters,
                             const FixedPoint<D>& fixed_point, double h) {
    const double softening = 0.01 * h * h;
    return h * reduce_blocks(
                   clusters.size(), block_clusters, 0.0,
                   [&](std::size_t begin, std::size_t end) {
                       double largest = 0.0;
                       for_listed_pairs<D>(
                           *data.fluid_fluid, clusters, data.motion, data.motion, fixed_point, 2.0 * h, begin,
                           end, [&](std::size_t i, std::size_t j, const Vec<D>& r, double squared) {
                               double along = 0.0;
                               for (std::size_t k = 0; k < D; ++k) {
                                   along +=
                                       static_cast<double>(data.motion[i].u[k] - data.motion[j].u[k]) * r[k];
                               }
                               largest = std::max(largest, std::abs(along) / (squared + softening));
                           });
                       return largest;
                   },
                   [](double a, double b) { return std::max(a, b); });
}

template double largest_pair_approach(const PairData<2, float>&, const Clusters<2>&, const FixedPoint<2>&,
                                      double);
template double largest_pair_approach(const PairData<2, double>&, const Clusters<2>&, const FixedPoint<2>&,
                                      double);
template double largest_pair_approach(const PairData<3, float>&, const Clusters<3>&, const FixedPoint<3>&,
                                      double);
template double largest_pair_approach(const PairData<3, double>&, const Clusters<3>&, const FixedPoint<3>&,
                                      double);

}  // namespace riffle::inline sph
