#include "particles/neighbour_list.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace riffle {

namespace {

/// Columns of the j side within `range` of the box of an i-cluster along one axis, each once.
template <int D>
void column_range(const Clusters<D>& j, std::size_t axis, double low, double high, std::vector<int>& result) {
    result.clear();
    const int count = j.columns[axis];
    const int first = static_cast<int>(std::floor((low - j.lower[axis]) / j.column_width[axis]));
    const int last = static_cast<int>(std::floor((high - j.lower[axis]) / j.column_width[axis]));
    if (j.periodic[axis]) {
        const int n = std::min(last - first + 1, count);
        for (int c = 0; c < n; ++c) {
            result.push_back(((first + c) % count + count) % count);
        }
    } else {
        for (int c = std::clamp(first, 0, count - 1); c <= std::clamp(last, 0, count - 1); ++c) {
            result.push_back(c);
        }
    }
}

/// Smallest distance of two boxes along one axis.
float box_gap(std::int32_t centre_i, float half_i, std::int32_t centre_j, float half_j, float unit) {
    const float distance = std::abs(static_cast<float>(wrapped_difference(centre_i, centre_j)) * unit);
    return std::max(0.0F, distance - half_i - half_j);
}

template <int D>
struct Search {
    const Clusters<D>& i;
    const Clusters<D>& j;
    std::array<float, static_cast<std::size_t>(D)> unit{};
    float range_squared = 0;

    /// Whether clusters ci and cj come within range.
    [[nodiscard]] bool near(std::size_t ci, std::size_t cj) const {
        float squared = 0;
        for (std::size_t k = 0; k < D; ++k) {
            const float gap = box_gap(i.centre[k][ci], i.half_extent[k][ci], j.centre[k][cj],
                                      j.half_extent[k][cj], unit[k]);
            squared += gap * gap;
        }
        return squared <= range_squared;
    }

    /// Whether j-slot `slot` is within range of any particle of cluster ci.
    [[nodiscard]] bool in_range(std::size_t ci, std::size_t slot) const {
        float least = 2.0F * range_squared;
        for (std::size_t lane = ci * cluster_size; lane < (ci + 1) * cluster_size; ++lane) {
            float squared = 0;
            for (std::size_t k = 0; k < D; ++k) {
                const float d = static_cast<float>(
                                    wrapped_difference(i.slot_position[k][lane], j.slot_position[k][slot])) *
                                unit[k];
                squared += d * d;
            }
            least = std::min(least, squared);
        }
        return least <= range_squared;
    }
};

template <int D>
void search_cluster(const Search<D>& search, std::size_t ci, const Vec<D>& low, const Vec<D>& high,
                    std::array<std::vector<int>, 2>& columns, std::vector<std::int32_t>& slots,
                    std::vector<std::int32_t>& clusters) {
    for (std::size_t k = 0; k + 1 < D; ++k) {
        column_range(search.j, k, low[k], high[k], columns[k]);
    }
    if constexpr (D == 2) {
        columns[1].assign(1, 0);
    }
    const int stride = D == 3 ? search.j.columns[D - 2] : 1;
    for (const int cx : columns[0]) {
        for (const int cy : columns[1]) {
            const auto column = static_cast<std::size_t>(cx * stride + cy);
            for (auto cj = static_cast<std::size_t>(search.j.column_begin[column]);
                 cj < static_cast<std::size_t>(search.j.column_begin[column + 1]); ++cj) {
                if (!search.near(ci, cj)) {
                    continue;
                }
                const std::size_t before = slots.size();
                for (std::size_t slot = cj * cluster_size; slot < (cj + 1) * cluster_size; ++slot) {
                    if (search.j.particle_of_slot[slot] >= 0 && search.in_range(ci, slot)) {
                        slots.push_back(static_cast<std::int32_t>(slot));
                    }
                }
                if (slots.size() > before) {
                    clusters.push_back(static_cast<std::int32_t>(cj));
                }
            }
        }
    }
}

void append_lists(const std::vector<std::vector<std::int32_t>>& parts, std::vector<std::int32_t>& all) {
    std::size_t total = 0;
    for (const auto& part : parts) {
        total += part.size();
    }
    all.clear();
    all.reserve(total);
    for (const auto& part : parts) {
        all.insert(all.end(), part.begin(), part.end());
    }
}

}  // namespace

template <int D>
NeighbourList build_neighbour_list(const Clusters<D>& i_clusters, const Clusters<D>& j_clusters,
                                   const FixedPoint<D>& fixed_point, double range) {
    Search<D> search{.i = i_clusters, .j = j_clusters};
    // The margin covers the rounding of the single-precision distances.
    const double safe_range = range * (1.0 + 1e-5);
    search.range_squared = static_cast<float>(safe_range * safe_range);
    for (std::size_t k = 0; k < D; ++k) {
        search.unit[k] = static_cast<float>(fixed_point.unit(k));
    }

    const std::size_t n = i_clusters.size();
    NeighbourList list;
    list.begin.assign(n + 1, 0);
    list.cluster_begin.assign(n + 1, 0);
    constexpr std::size_t block = 32;
    const std::size_t blocks = (n + block - 1) / block;
    std::vector<std::vector<std::int32_t>> block_slots(blocks);
    std::vector<std::vector<std::int32_t>> block_clusters(blocks);
    parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
        auto& slots = block_slots[begin / block];
        auto& clusters = block_clusters[begin / block];
        std::array<std::vector<int>, 2> columns;
        for (std::size_t ci = begin; ci < end; ++ci) {
            Vec<D> low{};
            Vec<D> high{};
            for (std::size_t k = 0; k + 1 < D; ++k) {
                const double centre = fixed_point.decode(i_clusters.centre[k][ci], k);
                const double reach = static_cast<double>(i_clusters.half_extent[k][ci]) + safe_range;
                low[k] = centre - reach;
                high[k] = centre + reach;
            }
            const std::size_t slots_before = slots.size();
            const std::size_t clusters_before = clusters.size();
            search_cluster(search, ci, low, high, columns, slots, clusters);
            list.begin[ci + 1] = static_cast<std::uint32_t>(slots.size() - slots_before);
            list.cluster_begin[ci + 1] = static_cast<std::uint32_t>(clusters.size() - clusters_before);
        }
    });
    for (std::size_t c = 0; c < n; ++c) {
        list.begin[c + 1] += list.begin[c];
        list.cluster_begin[c + 1] += list.cluster_begin[c];
    }
    append_lists(block_slots, list.slots);
    append_lists(block_clusters, list.clusters);
    return list;
}

template NeighbourList build_neighbour_list<2>(const Clusters<2>&, const Clusters<2>&, const FixedPoint<2>&,
                                               double);
template NeighbourList build_neighbour_list<3>(const Clusters<3>&, const Clusters<3>&, const FixedPoint<3>&,
                                               double);

}  // namespace riffle
