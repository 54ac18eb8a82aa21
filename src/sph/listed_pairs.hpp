#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "particles/clusters.hpp"
#include "sph/neighbour_list.hpp"

namespace riffle::inline sph {

/// All neighbours of a list.
struct AllListed {
    bool operator()(std::size_t /*slot*/) const { return true; }
};

/// Call f(slot of i, slot of j, r, r^2) for each particle i of the clusters [begin, end) and all its listed
/// neighbours j nearer than `support` (m), itself included where the list holds it: r = x_i - x_j in m, in
/// double precision and in the order of the list. `own` and `others` are records, by slot, with a position x
/// in integer units; `wanted(slot of j)` tells which neighbours count, all where it is not given. For sums
/// outside the pair loops, where clearness counts more than speed.
template <int D, class Own, class Other, class F, class Wanted = AllListed>
void for_listed_pairs(const NeighbourList& list, const Clusters<D>& clusters, const std::vector<Own>& own,
                      const std::vector<Other>& others, const FixedPoint<D>& fixed_point, double support,
                      std::size_t begin, std::size_t end, const F& f, const Wanted& wanted = {}) {
    std::vector<std::int32_t> slots(list.buffer_size());
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const auto last = slots.begin() + static_cast<std::ptrdiff_t>(list.spell(cluster, slots.data()));
        const auto end_of_wanted = std::remove_if(
            slots.begin(), last, [&](std::int32_t slot) { return !wanted(static_cast<std::size_t>(slot)); });
        const auto n = static_cast<std::size_t>(end_of_wanted - slots.begin());
        const auto lanes = static_cast<std::size_t>(clusters.count(cluster));
        for (std::size_t i = cluster * cluster_size; i < cluster * cluster_size + lanes; ++i) {
            for (std::size_t neighbour = 0; neighbour < n; ++neighbour) {
                const auto j = static_cast<std::size_t>(slots[neighbour]);
                Vec<D> r{};
                double squared = 0.0;
                for (std::size_t k = 0; k < D; ++k) {
                    r[k] = wrapped_difference(own[i].x[k], others[j].x[k]) * fixed_point.unit(k);
                    squared += r[k] * r[k];
                }
                if (squared < support * support) f(i, j, r, squared);
            }
        }
    }
}

}  // namespace riffle::inline sph
