#include "engine/pass_order.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.hpp"

namespace riffle::inline engine {

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
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
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

/// Number of strips: as many for each thread, some so that a thread that is held up does not hold up all,
/// but long enough that most blocks wait for one strip alone. One where the blocks between the first pass
/// and the last, twice the reach, are more than a second-level cache of a mebibyte holds (three dimensions):
/// threads that go through the same blocks together then have more of them in the cache that they share.
std::size_t strips_of(std::size_t blocks, std::size_t reach, std::size_t threads) {
    constexpr std::size_t most_per_thread = 4;
    constexpr std::size_t good_length = 16;  // in reaches
    constexpr std::size_t least_length = 6;
    constexpr std::size_t longest_reach = 20;  // of 128 particles of some 200 bytes
    if (threads <= 1 || reach > longest_reach || blocks < threads * least_length * reach) return 1;
    return threads * std::clamp<std::size_t>(blocks / (threads * good_length * reach), 1, most_per_thread);
}

/// The waves of the blocks of all passes.
class WavesOfBlocks {
  public:
    using Waves = std::vector<std::uint32_t>;

    WavesOfBlocks(std::size_t blocks, std::size_t strips, std::size_t wave_blocks) : first_pass_(blocks) {
        std::uint32_t wave = 0;
        for (std::size_t strip = 0; strip < strips; ++strip) {
            const std::size_t end = (strip + 1) * blocks / strips;
            for (std::size_t block = strip * blocks / strips; block < end; block += wave_blocks, ++wave) {
                std::fill(
                    first_pass_.begin() + static_cast<std::ptrdiff_t>(block),
                    first_pass_.begin() + static_cast<std::ptrdiff_t>(std::min(block + wave_blocks, end)),
                    wave);
                strip_of_.push_back(strip);
            }
            begin_.push_back(strip_of_.size());
        }
        if (strips > 1 || strip_of_.empty()) strip_of_.push_back(strips);
    }

    [[nodiscard]] const Waves& first_pass() const { return first_pass_; }
    [[nodiscard]] const std::vector<std::size_t>& strip_begin() const { return begin_; }
    [[nodiscard]] std::size_t count() const { return strip_of_.size(); }

    /// Let a block wait for another one.
    void wait(std::uint32_t& wave, std::uint32_t for_wave) const {
        if (wave == nothing) {
            wave = for_wave;
        } else if (strip_of_[wave] == strip_of_[for_wave]) {
            wave = std::max(wave, for_wave);
        } else {
            wave = static_cast<std::uint32_t>(strip_of_.size() - 1);
        }
    }

    /// Wave of a block that waits for nothing yet.
    static constexpr auto nothing = std::numeric_limits<std::uint32_t>::max();

  private:
    Waves first_pass_;
    std::vector<std::size_t> begin_{0};
    std::vector<std::size_t> strip_of_;  ///< by wave
};

}  // namespace

BlocksOfPass::BlocksOfPass(std::span<const std::uint32_t> wave_of_block, std::size_t waves)
    : blocks_(wave_of_block.size()), begin_(waves + 1) {
    for (const std::uint32_t wave : wave_of_block) ++begin_[wave + 1];
    for (std::size_t wave = 0; wave < waves; ++wave) begin_[wave + 1] += begin_[wave];
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t block = 0; block < wave_of_block.size(); ++block) {
        blocks_[next[wave_of_block[block]]++] = static_cast<std::uint32_t>(block);
    }
}

namespace {

using Waves = WavesOfBlocks::Waves;

bool share(const PassDeclaration::Fields& a, const PassDeclaration::Fields& b) {
    return std::any_of(a.begin(), a.end(), [&b](std::string_view field) {
        return std::find(b.begin(), b.end(), field) != b.end();
    });
}

/// Whether a pass reads of its neighbours in a set what `fields` names.
bool reads_of_neighbours(const PassDeclaration& pass, std::size_t set,
                         const PassDeclaration::Fields& fields) {
    return std::any_of(pass.neighbours.begin(), pass.neighbours.end(),
                       [&](const auto& read) { return read.set == set && share(read.fields, fields); });
}

/// Whether a pass must wait for an earlier one over the same block.
bool waits_on_block(const PassDeclaration& later, const PassDeclaration& earlier) {
    return later.set == earlier.set &&
           (share(earlier.writes, later.reads) || share(earlier.reads, later.writes) ||
            share(earlier.writes, later.writes));
}

/// The pairs of blocks of each list, found once.
class ListedBlocks {
  public:
    ListedBlocks(std::span<const ListBetween> lists, std::span<const std::size_t> set_sizes) {
        for (const ListBetween& between : lists) {
            lists_.push_back(
                {between.from, between.to, listed_blocks(*between.list, blocks_of(set_sizes[between.to]))});
        }
    }
    /// Empty where there is no such list.
    [[nodiscard]] const std::vector<BlockPair>& between(std::size_t from, std::size_t to) const {
        static const std::vector<BlockPair> none;
        const auto found = std::find_if(lists_.begin(), lists_.end(), [&](const Pairs& pairs) {
            return pairs.from == from && pairs.to == to;
        });
        return found == lists_.end() ? none : found->blocks;
    }

  private:
    struct Pairs {
        std::size_t from;
        std::size_t to;
        std::vector<BlockPair> blocks;
    };
    std::vector<Pairs> lists_;
};

}  // namespace

PassOrder order_passes(std::span<const PassDeclaration> passes, std::span<const ListBetween> lists,
                       std::span<const std::size_t> set_sizes, PassPlan plan) {
    const std::size_t leading = passes[0].set;
    const std::size_t blocks = blocks_of(set_sizes[leading]);
    if (std::any_of(passes.begin(), passes.end(), [](const PassDeclaration& pass) { return pass.whole; })) {
        plan = {.threads = 1, .wave_blocks = blocks};
    }
    const ListedBlocks listed(lists, set_sizes);
    const std::size_t strips =
        strips_of(blocks, reach_of(listed.between(leading, leading), blocks), plan.threads);
    const bool shared = plan.threads > 1 && strips == 1;
    const WavesOfBlocks groups(blocks, strips,
                               shared ? plan.shared_wave_blocks * plan.threads : plan.wave_blocks);

    std::vector<Waves> waves;
    for (std::size_t p = 0; p < passes.size(); ++p) {
        const PassDeclaration& pass = passes[p];
        if (pass.whole) {
            waves.emplace_back();
            continue;
        }
        Waves own =
            p == 0 ? groups.first_pass() : Waves(blocks_of(set_sizes[pass.set]), WavesOfBlocks::nothing);
        for (std::size_t q = 0; q < p; ++q) {
            const PassDeclaration& earlier = passes[q];
            if (earlier.whole) {
                continue;  // all are in one wave
            }
            if (waits_on_block(pass, earlier)) {
                for (std::size_t block = 0; block < own.size(); ++block) {
                    groups.wait(own[block], waves[q][block]);
                }
            }
            if (reads_of_neighbours(pass, earlier.set, earlier.writes)) {
                for (const auto& [i, j] : listed.between(pass.set, earlier.set)) {
                    groups.wait(own[i], waves[q][j]);
                }
            }
            if (reads_of_neighbours(earlier, pass.set, pass.writes)) {
                for (const auto& [i, j] : listed.between(earlier.set, pass.set)) {
                    groups.wait(own[j], waves[q][i]);
                }
            }
        }
        std::replace(own.begin(), own.end(), WavesOfBlocks::nothing, std::uint32_t{0});
        waves.push_back(std::move(own));
    }
    PassOrder order{.waves = groups.count(), .passes = {}, .strip_begin = groups.strip_begin()};
    for (const Waves& own : waves) order.passes.emplace_back(own, order.waves);
    return order;
}

}  // namespace riffle::inline engine
