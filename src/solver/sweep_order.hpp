#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sph/pair_loops.hpp"

namespace riffle {

/// Number of blocks that so many clusters make.
[[nodiscard]] constexpr std::size_t blocks_of(std::size_t clusters) {
    return (clusters + block_clusters - 1) / block_clusters;
}

/// The blocks of a sweep by the wave in which they run.
class SweepStage {
  public:
    SweepStage() = default;
    /// From the wave of each block.
    SweepStage(std::span<const std::uint32_t> wave_of_block, std::size_t waves);

    /// Blocks of a wave, ascending.
    [[nodiscard]] std::span<const std::uint32_t> blocks(std::size_t wave) const {
        return {blocks_.data() + begin_[wave], begin_[wave + 1] - begin_[wave]};
    }

  private:
    std::vector<std::uint32_t> blocks_;
    std::vector<std::size_t> begin_;
};

/// Lists that say which clusters' records a cluster's sums read.
struct SweepLists {
    const NeighbourList* fluid_fluid = nullptr;
    const NeighbourList* fluid_wall = nullptr;  ///< null without walls, as the next one
    const NeighbourList* wall_fluid = nullptr;
};

/// In which order the sweeps of a force evaluation may pass over the blocks of clusters, so that each block
/// goes through all of them while its records are still in the caches, instead of each sweep fetching all
/// particles from memory again. The blocks follow each other in space. In wave w run the gradients of the
/// w-th group of blocks, then the walls, the forces and the packing of those blocks whose neighbours have
/// come far enough:
///
/// - the walls wait for the gradients of all fluid that they read, and that reads them;
/// - forces wait for the gradients and walls that they read;
/// - packing, which overwrites the positions, waits for all forces and walls that read them.
///
/// For several threads the channel is divided into sections of consecutive waves. A block waits for blocks of
/// its own section alone, so that the sections can run beside each other, each in one thread; blocks that
/// must wait for another section run in a last wave, when all are done.
///
/// The result does not depend on the order.
struct SweepOrder {
    std::size_t waves = 1;
    SweepStage gradients, walls, forces, packing;
    /// First wave of each section, and the end of the last one. With more than one section another wave
    /// follows, which belongs to none.
    std::vector<std::size_t> section_begin{0, 1};

    [[nodiscard]] std::size_t sections() const { return section_begin.size() - 1; }
};

/// How finely to divide the sweeps.
struct SweepPlan {
    std::size_t threads = 1;
    /// Blocks of a wave of one thread: few, so that what a wave reads and writes stays in the second-level
    /// cache.
    std::size_t wave_blocks = 8;
    /// Blocks for each thread of a wave that the threads share, where the channel is too short for sections:
    /// enough that waiting for each other at its end costs little.
    std::size_t shared_wave_blocks = 32;
};

[[nodiscard]] SweepOrder order_sweeps(const SweepLists& lists, const SweepPlan& plan);

}  // namespace riffle
