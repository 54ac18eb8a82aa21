#include "sph/directed_pairs.hpp"

#include "base/parallel.hpp"
#include "sph/listed_pairs.hpp"

namespace riffle::inline sph {

template <int D, class Real>
double count_directed_pairs(const PairData<D, Real>& data, const Clusters<D>& clusters,
                            const FixedPoint<D>& fixed_point, double support) {
    const std::int64_t pairs = reduce_blocks(
        clusters.size(), block_clusters, std::int64_t{0},
        [&](std::size_t begin, std::size_t end) {
            std::int64_t count = 0;
            const auto add = [&](const NeighbourList& list, const auto& records) {
                for_listed_pairs<D>(list, clusters, data.motion, records, fixed_point, support, begin, end,
                                    [&](std::size_t, std::size_t, const Vec<D>&, double) { ++count; });
            };
            add(*data.fluid_fluid, data.motion);
            if (data.fluid_wall != nullptr) add(*data.fluid_wall, data.wall_gradient);
            // Each is its own neighbour.
            return count - (clusters.begin[end] - clusters.begin[begin]);
        },
        [](std::int64_t a, std::int64_t b) { return a + b; });
    return static_cast<double>(pairs);
}

template double count_directed_pairs(const PairData<2, float>&, const Clusters<2>&, const FixedPoint<2>&,
                                     double);
template double count_directed_pairs(const PairData<2, double>&, const Clusters<2>&, const FixedPoint<2>&,
                                     double);
template double count_directed_pairs(const PairData<3, float>&, const Clusters<3>&, const FixedPoint<3>&,
                                     double);
template double count_directed_pairs(const PairData<3, double>&, const Clusters<3>&, const FixedPoint<3>&,
                                     double);

}  // namespace riffle::inline sph
