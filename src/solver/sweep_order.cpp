#include "solver/sweep_order.hpp"

#include <algorithm>
#include <atomic>

#include "base/parallel.hpp"

namespace riffle {

namespace {

using Waves = std::vector<std::uint32_t>;

void raise(std::uint32_t& value, std::uint32_t least) {
    const std::atomic_ref<std::uint32_t> shared(value);
    std::uint32_t present = shared.load(std::memory_order_relaxed);
    while (present < least && !shared.compare_exchange_weak(present, least, std::memory_order_relaxed)) {
    }
}

/// f(block of i-clusters, block of j-clusters) for all blocks whose clusters stand in each other's lists, in
/// parallel over the former.
template <class F>
void for_listed_blocks(const NeighbourList& list, const F& f) {
    parallel_blocks(list.size(), block_clusters, [&](std::size_t begin, std::size_t end) {
        const auto i = begin / block_clusters;
        for (std::size_t run = list.run_begin[begin]; run < list.run_begin[end]; ++run) {
            const std::size_t first = list.runs[run].first;
            const std::size_t last = first + list.runs[run].count - 1;
            for (std::size_t j = first / block_clusters; j <= last / block_clusters; ++j) {
                f(i, j);
            }
        }
    });
}

}  // namespace

SweepStage::SweepStage(std::span<const std::uint32_t> wave_of_block, std::size_t waves)
    : blocks_(wave_of_block.size()), begin_(waves + 1) {
    for (const std::uint32_t wave : wave_of_block) {
        ++begin_[wave + 1];
    }
    for (std::size_t wave = 0; wave < waves; ++wave) {
        begin_[wave + 1] += begin_[wave];
    }
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t block = 0; block < wave_of_block.size(); ++block) {
        blocks_[next[wave_of_block[block]]++] = static_cast<std::uint32_t>(block);
    }
}

SweepOrder order_sweeps(const SweepLists& lists, std::size_t wave_blocks) {
    const auto blocks_of = [&](const NeighbourList* list) {
        return list == nullptr ? 0 : (list->size() + block_clusters - 1) / block_clusters;
    };
    const std::size_t fluid_blocks = blocks_of(lists.fluid_fluid);
    const std::size_t waves = std::max<std::size_t>(1, (fluid_blocks + wave_blocks - 1) / wave_blocks);
    Waves gradients(fluid_blocks);
    for (std::size_t block = 0; block < fluid_blocks; ++block) {
        gradients[block] = static_cast<std::uint32_t>(block / wave_blocks);
    }
    Waves walls(blocks_of(lists.wall_fluid));
    Waves forces = gradients;
    Waves packing = gradients;
    if (waves > 1) {
        if (lists.wall_fluid != nullptr) {
            for_listed_blocks(*lists.wall_fluid,
                              [&](std::size_t i, std::size_t j) { raise(walls[i], gradients[j]); });
            for_listed_blocks(*lists.fluid_wall,
                              [&](std::size_t i, std::size_t j) { raise(walls[j], gradients[i]); });
            for_listed_blocks(*lists.fluid_wall,
                              [&](std::size_t i, std::size_t j) { raise(forces[i], walls[j]); });
        }
        for_listed_blocks(*lists.fluid_fluid,
                          [&](std::size_t i, std::size_t j) { raise(forces[i], gradients[j]); });
        for_listed_blocks(*lists.fluid_fluid,
                          [&](std::size_t i, std::size_t j) { raise(packing[j], forces[i]); });
        if (lists.wall_fluid != nullptr) {
            for_listed_blocks(*lists.wall_fluid,
                              [&](std::size_t i, std::size_t j) { raise(packing[j], walls[i]); });
        }
    }
    return {.waves = waves,
            .gradients = {gradients, waves},
            .walls = {walls, waves},
            .forces = {forces, waves},
            .packing = {packing, waves}};
}

}  // namespace riffle
