#include "solver/sweep_order.hpp"

#include <algorithm>
#include <limits>

#include "base/parallel.hpp"

namespace riffle {

namespace {

/// A block of i-clusters and one of j-clusters that stand in their lists.
struct BlockPair {
    std::uint32_t i;
    std::uint32_t j;
};

/// All pairs of blocks of a list, each once, of `j_blocks` on the j side.
std::vector<BlockPair> listed_blocks(const NeighbourList& list, std::size_t j_blocks) {
    const std::size_t i_blocks = blocks_of(list.size());
    // Each task looks at all j-blocks once, so not too many tasks.
    const std::size_t task_blocks = std::max<std::size_t>(64, (i_blocks + 63) / 64);
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

/// How far apart, in blocks, the two of a pair stand, along the channel or through its period.
std::size_t reach_of(const std::vector<BlockPair>& pairs, std::size_t blocks) {
    std::size_t reach = 1;
    for (const auto& [i, j] : pairs) {
        const std::size_t apart = i < j ? j - i : i - j;
        reach = std::max(reach, std::min(apart, blocks - apart));
    }
    return reach;
}

/// Number of sections: as many for each thread, some so that a thread that is held up does not hold up all,
/// but long enough that most blocks wait for one section alone. One where the blocks between the first sweep
/// and the last, twice the reach, are more than a second-level cache of a mebibyte holds (three dimensions):
/// threads that go through the same blocks together then have more of them in the cache that they share.
std::size_t sections_of(std::size_t blocks, std::size_t reach, std::size_t threads) {
    constexpr std::size_t most_per_thread = 4;
    constexpr std::size_t good_length = 16;  // in reaches
    constexpr std::size_t least_length = 6;
    constexpr std::size_t longest_reach = 20;  // of 128 particles of some 200 bytes
    if (threads <= 1 || reach > longest_reach || blocks < threads * least_length * reach) {
        return 1;
    }
    return threads * std::clamp<std::size_t>(blocks / (threads * good_length * reach), 1, most_per_thread);
}

/// The waves of the blocks of all sweeps.
class WavesOfBlocks {
  public:
    using Waves = std::vector<std::uint32_t>;

    WavesOfBlocks(std::size_t blocks, std::size_t sections, std::size_t wave_blocks) : gradients_(blocks) {
        std::uint32_t wave = 0;
        for (std::size_t section = 0; section < sections; ++section) {
            const std::size_t end = (section + 1) * blocks / sections;
            for (std::size_t block = section * blocks / sections; block < end; block += wave_blocks, ++wave) {
                std::fill(
                    gradients_.begin() + static_cast<std::ptrdiff_t>(block),
                    gradients_.begin() + static_cast<std::ptrdiff_t>(std::min(block + wave_blocks, end)),
                    wave);
                section_of_.push_back(section);
            }
            begin_.push_back(section_of_.size());
        }
        if (sections > 1 || section_of_.empty()) {
            section_of_.push_back(sections);
        }
    }

    [[nodiscard]] const Waves& gradients() const { return gradients_; }
    [[nodiscard]] const std::vector<std::size_t>& section_begin() const { return begin_; }
    [[nodiscard]] std::size_t count() const { return section_of_.size(); }

    /// Let a block wait for another one.
    void wait(std::uint32_t& wave, std::uint32_t for_wave) const {
        if (wave == nothing) {
            wave = for_wave;
        } else if (section_of_[wave] == section_of_[for_wave]) {
            wave = std::max(wave, for_wave);
        } else {
            wave = static_cast<std::uint32_t>(section_of_.size() - 1);
        }
    }

    /// Wave of a block that waits for nothing yet.
    static constexpr auto nothing = std::numeric_limits<std::uint32_t>::max();

  private:
    Waves gradients_;
    std::vector<std::size_t> begin_{0};
    std::vector<std::size_t> section_of_;  ///< by wave
};

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

SweepOrder order_sweeps(const SweepLists& lists, const SweepPlan& plan) {
    const std::size_t fluid_blocks = blocks_of(lists.fluid_fluid->size());
    const std::size_t wall_blocks = lists.wall_fluid == nullptr ? 0 : blocks_of(lists.wall_fluid->size());
    const std::vector<BlockPair> fluid_fluid = listed_blocks(*lists.fluid_fluid, fluid_blocks);
    const std::size_t sections = sections_of(fluid_blocks, reach_of(fluid_fluid, fluid_blocks), plan.threads);
    const bool shared = plan.threads > 1 && sections == 1;
    const WavesOfBlocks waves(fluid_blocks, sections,
                              shared ? plan.shared_wave_blocks * plan.threads : plan.wave_blocks);
    WavesOfBlocks::Waves walls(wall_blocks, WavesOfBlocks::nothing);
    WavesOfBlocks::Waves forces = waves.gradients();
    std::vector<BlockPair> wall_fluid;
    if (wall_blocks > 0) {
        wall_fluid = listed_blocks(*lists.wall_fluid, fluid_blocks);
        const std::vector<BlockPair> fluid_wall = listed_blocks(*lists.fluid_wall, wall_blocks);
        for (const auto& [wall, fluid] : wall_fluid) {
            waves.wait(walls[wall], waves.gradients()[fluid]);
        }
        for (const auto& [fluid, wall] : fluid_wall) {
            waves.wait(walls[wall], waves.gradients()[fluid]);
        }
        std::replace(walls.begin(), walls.end(), WavesOfBlocks::nothing, std::uint32_t{0});
        for (const auto& [fluid, wall] : fluid_wall) {
            waves.wait(forces[fluid], walls[wall]);
        }
    }
    for (const auto& [i, j] : fluid_fluid) {
        waves.wait(forces[i], waves.gradients()[j]);
    }
    WavesOfBlocks::Waves packing = waves.gradients();
    for (const auto& [i, j] : fluid_fluid) {
        waves.wait(packing[j], forces[i]);
    }
    for (const auto& [wall, fluid] : wall_fluid) {
        waves.wait(packing[fluid], walls[wall]);
    }
    const std::size_t count = waves.count();
    return {.waves = count,
            .gradients = {waves.gradients(), count},
            .walls = {walls, count},
            .forces = {forces, count},
            .packing = {packing, count},
            .section_begin = waves.section_begin()};
}

}  // namespace riffle
