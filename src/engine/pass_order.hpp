#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sph/pair_loops.hpp"

namespace riffle::inline engine {

/// Number of blocks that so many clusters make.
[[nodiscard]] constexpr std::size_t blocks_of(std::size_t clusters) {
    return (clusters + block_clusters - 1) / block_clusters;
}

/// What a pass over the particles of a set reads and writes. Sets are numbered; fields have names, of which
/// only equality counts.
struct PassDeclaration {
    using Fields = std::vector<std::string_view>;
    /// What it reads of the particles of a set that stand in the lists of its own.
    struct NeighbourFields {
        std::size_t set = 0;
        Fields fields;
    };

    std::string_view name;
    std::size_t set = 0;
    Fields reads{};  ///< of the particles themselves
    std::vector<NeighbourFields> neighbours{};
    Fields writes{};  ///< of the particles themselves
    /// It is no pass over blocks but looks at the whole of all sets: all that stands before it is done first,
    /// and what stands behind it follows.
    bool whole = false;
};

/// A list of neighbours from one set in another.
struct ListBetween {
    std::size_t from = 0;
    std::size_t to = 0;
    const NeighbourList* list = nullptr;
};

/// How finely to divide the passes.
struct PassPlan {
    std::size_t threads = 1;
    /// Blocks of a wave of one thread: few, so that what a wave reads and writes stays in the second-level
    /// cache.
    std::size_t wave_blocks = 8;
    /// Blocks for each thread of a wave that the threads share, where the channel is too short for strips:
    /// enough that waiting for each other at its end costs little.
    std::size_t shared_wave_blocks = 32;
};

/// The blocks of a pass by the wave in which they run.
class BlocksOfPass {
  public:
    BlocksOfPass() = default;
    /// From the wave of each block.
    BlocksOfPass(std::span<const std::uint32_t> wave_of_block, std::size_t waves);

    /// Blocks of a wave, ascending.
    [[nodiscard]] std::span<const std::uint32_t> blocks(std::size_t wave) const {
        return {blocks_.data() + begin_[wave], begin_[wave + 1] - begin_[wave]};
    }

  private:
    std::vector<std::uint32_t> blocks_;
    std::vector<std::size_t> begin_;
};

/// In which order the passes of an evaluation may go over the blocks of clusters, so that each block goes
/// through all of them while its records are still in the caches, instead of each pass fetching all particles
/// from memory again. The blocks follow each other in space. The first pass goes over groups of blocks of its
/// set, one group a wave; each further pass follows in the same or a later wave, as soon as it may. In a wave
/// the passes run one after the other.
///
/// A pass may run on a block when the passes before it that
///
/// - write what it reads, of the block itself or of its neighbours, have run there;
/// - read what it writes, on the block itself or on blocks of which it is a neighbour, have run there;
/// - write what it writes have run on the block.
///
/// For several threads the channel is divided into strips of consecutive waves. A block waits for blocks of
/// its own strip alone, so that the strips can run beside each other, each in one thread; blocks that must
/// wait for another strip run in a last wave, when all are done.
///
/// The result does not depend on the order.
struct PassOrder {
    std::size_t waves = 1;
    std::vector<BlocksOfPass> passes;  ///< as declared
    /// First wave of each strip, and the end of the last one. With more than one strip another wave follows,
    /// which belongs to none.
    std::vector<std::size_t> strip_begin{0, 1};

    [[nodiscard]] std::size_t strips() const { return strip_begin.size() - 1; }
};

/// `set_sizes`: clusters of each set. The set of the first pass needs a list in itself, which says how far
/// the neighbours of a block reach. Sets between which there is no list do not see each other.
[[nodiscard]] PassOrder order_passes(std::span<const PassDeclaration> passes,
                                     std::span<const ListBetween> lists,
                                     std::span<const std::size_t> set_sizes, PassPlan plan);

}  // namespace riffle::inline engine
