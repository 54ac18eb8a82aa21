#include "solver/sweep_order.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace riffle {

namespace {

/// A block of i-clusters and one of j-clusters that stand in their lists.
struct BlockPair {
    std::uint32_t i;
    std::uint32_t j;
};

std::size_t blocks_of(const NeighbourList& list) {
    return (list.size() + block_clusters - 1) / block_clusters;
}

/// All pairs of blocks of a list, each once, of `j_blocks` on the j side.
std::vector<BlockPair> listed_blocks(const NeighbourList& list, std::size_t j_blocks) {
    constexpr std::size_t task_blocks = 64;
    const std::size_t i_blocks = blocks_of(list);
    std::vector<std::vector<BlockPair>> parts((i_blocks + task_blocks - 1) / task_blocks);
    parallel_blocks(i_blocks, task_blocks, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> met_by(j_blocks, 0);  // the last i-block that has met it, from 1
        for (std::size_t i = begin; i < end; ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            const std::size_t last = std::min((i + 1) * block_clusters, list.size());
            for (std::size_t run = list.run_begin[i * block_clusters]; run < list.run_begin[last]; ++run) {
                const std::size_t j_first = list.runs[run].first / block_clusters;
                const std::size_t j_last = (list.runs[run].first + list.runs[run].count - 1) / block_clusters;
                for (std::size_t j = j_first; j <= j_last; ++j) {
                    if (met_by[j] != number + 1) {
                        met_by[j] = number + 1;
                        parts[begin / task_blocks].push_back({number, static_cast<std::uint32_t>(j)});
                    }
                }
            }
        }
    });
    std::vector<BlockPair> all;
    for (const auto& part : parts) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

using Waves = std::vector<std::uint32_t>;

void raise(std::uint32_t& value, std::uint32_t least) { value = std::max(value, least); }

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
    const std::size_t fluid_blocks = blocks_of(*lists.fluid_fluid);
    const std::size_t wall_blocks = lists.wall_fluid == nullptr ? 0 : blocks_of(*lists.wall_fluid);
    const std::size_t waves = std::max<std::size_t>(1, (fluid_blocks + wave_blocks - 1) / wave_blocks);
    Waves gradients(fluid_blocks);
    for (std::size_t block = 0; block < fluid_blocks; ++block) {
        gradients[block] = static_cast<std::uint32_t>(block / wave_blocks);
    }
    Waves walls(wall_blocks);
    Waves forces = gradients;
    Waves packing = gradients;
    if (waves > 1) {
        const std::vector<BlockPair> fluid_fluid = listed_blocks(*lists.fluid_fluid, fluid_blocks);
        std::vector<BlockPair> wall_fluid;
        if (wall_blocks > 0) {
            wall_fluid = listed_blocks(*lists.wall_fluid, fluid_blocks);
            const std::vector<BlockPair> fluid_wall = listed_blocks(*lists.fluid_wall, wall_blocks);
            for (const auto& [wall, fluid] : wall_fluid) {
                raise(walls[wall], gradients[fluid]);
            }
            for (const auto& [fluid, wall] : fluid_wall) {
                raise(walls[wall], gradients[fluid]);
            }
            for (const auto& [fluid, wall] : fluid_wall) {
                raise(forces[fluid], walls[wall]);
            }
        }
        for (const auto& [i, j] : fluid_fluid) {
            raise(forces[i], gradients[j]);
        }
        for (const auto& [i, j] : fluid_fluid) {
            raise(packing[j], forces[i]);
        }
        for (const auto& [wall, fluid] : wall_fluid) {
            raise(packing[fluid], walls[wall]);
        }
    }
    return {.waves = waves,
            .gradients = {gradients, waves},
            .walls = {walls, waves},
            .forces = {forces, waves},
            .packing = {packing, waves}};
}

}  // namespace riffle
