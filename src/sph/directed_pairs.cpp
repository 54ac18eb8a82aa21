#include "sph/directed_pairs.hpp"

#include "base/parallel.hpp"

namespace riffle {

template <int D, class Real>
double count_directed_pairs(const PairData<D, Real>& data, const Clusters<D>& clusters,
                            const FixedPoint<D>& fixed_point, double support) {
    const auto within = [&](const auto& a, const auto& b) {
        double squared = 0.0;
        for (std::size_t k = 0; k < D; ++k) {
            const double d = wrapped_difference(a.x[k], b.x[k]) * fixed_point.unit(k);
            squared += d * d;
        }
        return squared < support * support;
    };
    const std::int64_t pairs = reduce_blocks(
        clusters.size(), block_clusters, std::int64_t{0},
        [&](std::size_t begin, std::size_t end) {
            std::int64_t count = 0;
            std::vector<std::int32_t> slots;
            const auto add = [&](const NeighbourList& list, const auto& records, std::size_t cluster) {
                slots.resize(list.buffer_size());
                const std::size_t n = list.spell(cluster, slots.data());
                const auto lanes = static_cast<std::size_t>(clusters.count(cluster));
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    const auto& own = data.motion[cluster * cluster_size + lane];
                    for (std::size_t j = 0; j < n; ++j) {
                        count += within(own, records[static_cast<std::size_t>(slots[j])]) ? 1 : 0;
                    }
                }
            };
            for (std::size_t cluster = begin; cluster < end; ++cluster) {
                add(*data.fluid_fluid, data.motion, cluster);
                if (data.fluid_wall != nullptr) {
                    add(*data.fluid_wall, data.wall_gradient, cluster);
                }
                count -= clusters.count(cluster);  // each is its own neighbour
            }
            return count;
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

}  // namespace riffle
