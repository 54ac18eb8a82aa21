#include "sph/neighbour_list.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::inline sph {

namespace {

constexpr std::size_t search_block = NeighbourBlock::size;

/// Offsets of block results in the whole list.
struct BlockPlace {
    std::size_t runs = 0;
    std::size_t masks = 0;
};

}  // namespace

void NeighbourBlock::grow(std::size_t runs, std::size_t masks) {
    runs_.resize(std::max(run_count_ + runs, 2 * runs_.size()));
    masks_.resize(std::max(mask_count_ + masks, 2 * masks_.size()));
}

void NeighbourBlock::clear() {
    run_count_ = 0;
    mask_count_ = 0;
    largest = 0;
    neighbours = 0;
}

NeighbourBlock NeighbourBlock::trimmed() const {
    NeighbourBlock result;
    result.cluster_runs = cluster_runs;
    result.cluster_masks = cluster_masks;
    result.largest = largest;
    result.neighbours = neighbours;
    result.runs_.assign(runs_.begin(), runs_.begin() + static_cast<std::ptrdiff_t>(run_count_));
    result.masks_.assign(masks_.begin(), masks_.begin() + static_cast<std::ptrdiff_t>(mask_count_));
    result.run_count_ = run_count_;
    result.mask_count_ = mask_count_;
    return result;
}

std::size_t NeighbourList::bytes() const {
    return run_begin.capacity() * sizeof(run_begin[0]) + runs.capacity() * sizeof(ClusterRun) +
           mask_begin.capacity() * sizeof(mask_begin[0]) + masks.capacity();
}

template <int D>
NeighbourList build_neighbour_list(const Clusters<D>& i_clusters, const Clusters<D>& j_clusters,
                                   const FixedPoint<D>& fixed_point, double range) {
    // The margin covers the rounding of the single-precision distances.
    const NeighbourSearch<D> search{
        .i = &i_clusters, .j = &j_clusters, .fixed_point = &fixed_point, .range = range * (1.0 + 1e-5)};
    if (j_clusters.size() >= ClusterRun::most_clusters) {
        throw RunError(
            "neighbour lists number up to 2^27 clusters of 8 particles; take a larger spacing or a shorter "
            "channel");
    }
    const NeighbourSearchFunction<D> find = neighbour_search<D>();
    const std::size_t n = i_clusters.size();
    std::vector<NeighbourBlock> blocks((n + search_block - 1) / search_block);
    parallel_blocks(n, search_block, [&](std::size_t begin, std::size_t end) {
        thread_local NeighbourBlock found;  // grows once, not with every block
        found.clear();
        find(search, begin, end, found);
        blocks[begin / search_block] = found.trimmed();
    });

    NeighbourList list;
    list.empty_slot = static_cast<std::int32_t>(j_clusters.slots());
    std::vector<BlockPlace> place(blocks.size() + 1);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        place[b + 1] = {place[b].runs + blocks[b].run_count(), place[b].masks + blocks[b].mask_count()};
        list.largest = std::max(list.largest, blocks[b].largest);
        list.neighbours += blocks[b].neighbours;
    }
    list.runs.resize(place.back().runs);
    list.masks.resize(place.back().masks);
    list.run_begin.resize(n + 1);
    list.mask_begin.resize(n + 1);
    list.run_begin[n] = static_cast<std::uint32_t>(place.back().runs);
    list.mask_begin[n] = static_cast<std::uint32_t>(place.back().masks);
    parallel_blocks(n, search_block, [&](std::size_t begin, std::size_t end) {
        const std::size_t b = begin / search_block;
        const NeighbourBlock& block = blocks[b];
        std::copy_n(block.runs().begin(), block.run_count(),
                    list.runs.begin() + static_cast<std::ptrdiff_t>(place[b].runs));
        std::copy_n(block.masks().begin(), block.mask_count(),
                    list.masks.begin() + static_cast<std::ptrdiff_t>(place[b].masks));
        auto run = static_cast<std::uint32_t>(place[b].runs);
        auto mask = static_cast<std::uint32_t>(place[b].masks);
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            list.run_begin[cluster] = run;
            list.mask_begin[cluster] = mask;
            run += block.cluster_runs[cluster - begin];
            mask += block.cluster_masks[cluster - begin];
        }
    });
    return list;
}

template NeighbourList build_neighbour_list<2>(const Clusters<2>&, const Clusters<2>&, const FixedPoint<2>&,
                                               double);
template NeighbourList build_neighbour_list<3>(const Clusters<3>&, const Clusters<3>&, const FixedPoint<3>&,
                                               double);

}  // namespace riffle::inline sph
