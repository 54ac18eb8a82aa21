#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "particles/clusters.hpp"
#include "particles/domain.hpp"

namespace riffle {

/// For each i-cluster, the slots of all j-particles that lie within `range` of any of its particles (a full
/// list: each pair stands in the lists of both clusters, so sums need no atomics and have a fixed order).
struct NeighbourList {
    std::vector<std::uint32_t> begin;          ///< clusters + 1 offsets into `slots`
    std::vector<std::int32_t> slots;           ///< j slots
    std::vector<std::uint32_t> cluster_begin;  ///< clusters + 1 offsets into `clusters`
    std::vector<std::int32_t> clusters;        ///< j clusters that hold those slots

    [[nodiscard]] std::span<const std::int32_t> of(std::size_t cluster) const {
        return {slots.data() + begin[cluster], begin[cluster + 1] - begin[cluster]};
    }
    [[nodiscard]] std::span<const std::int32_t> clusters_of(std::size_t cluster) const {
        return {clusters.data() + cluster_begin[cluster],
                cluster_begin[cluster + 1] - cluster_begin[cluster]};
    }
};

/// Build the list of j-slots within `range` (m) of each i-cluster. i and j may be the same clusters; a
/// particle is then its own neighbour (all pair terms vanish at zero distance). Both were built on the same
/// domain.
template <int D>
[[nodiscard]] NeighbourList build_neighbour_list(const Clusters<D>& i_clusters, const Clusters<D>& j_clusters,
                                                 const FixedPoint<D>& fixed_point, double range);

}  // namespace riffle
