#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "particles/clusters.hpp"

namespace riffle::inline sph {

/// Clusters [first, first + count) of one column, in 32 bits; longer runs are cut into several.
struct ClusterRun {
    std::uint32_t first : 27 = 0;
    std::uint32_t count : 5 = 0;

    static constexpr std::size_t most_clusters = std::size_t{1} << 27U;
    static constexpr std::size_t longest = 31;
};

/// For each i-cluster, the slots of all j-particles that lie within range of any of its particles (a full
/// list: each pair stands in the lists of both clusters, so sums need no atomics and have a fixed order).
/// Kept as runs of j-clusters with one bit per particle, a sixth of the size of the slots themselves; the
/// loops spell the slots of one cluster out at a time.
struct NeighbourList {
    std::vector<std::uint32_t> run_begin;   ///< clusters + 1 offsets into `runs`
    std::vector<ClusterRun> runs;           ///< j-clusters, column by column
    std::vector<std::uint32_t> mask_begin;  ///< clusters + 1 offsets into `masks`
    std::vector<std::uint8_t> masks;        ///< one per j-cluster of the runs: bit l for slot 8 c + l
    std::int32_t empty_slot = 0;            ///< a slot past the last one, of a record without volume
    std::size_t largest = 0;                ///< most neighbours that an i-cluster has
    std::size_t neighbours = 0;             ///< of all i-clusters together

    [[nodiscard]] std::size_t size() const { return run_begin.empty() ? 0 : run_begin.size() - 1; }

    /// Length of the buffer that spell() needs.
    [[nodiscard]] std::size_t buffer_size() const { return largest + 2 * lookahead; }

    /// How many entries behind the last one may be read, to fill turns up and to fetch ahead.
    static constexpr std::size_t lookahead = 48;

    /// The slots of a cluster's neighbours into `slots`, followed by `lookahead` times empty_slot; returns
    /// their number without those.
    std::size_t spell(std::size_t cluster, std::int32_t* slots) const;

    /// The same through a writer of 8 numbers: write.bits(base, mask, to) writes base plus the positions of
    /// the mask's bits, and anything behind them; write.same(value, to) a value 8 times.
    template <class Writer>
    std::size_t spell(std::size_t cluster, std::int32_t* slots, const Writer& write) const;

    /// Bytes held.
    [[nodiscard]] std::size_t bytes() const;
};

/// f(place in `masks`, slot) for all slots of the j-clusters of a cluster's runs, listed or masked out.
template <class F>
void for_listed_slots(const NeighbourList& list, std::size_t cluster, const F& f) {
    std::size_t mask = list.mask_begin[cluster];
    for (std::size_t run = list.run_begin[cluster]; run < list.run_begin[cluster + 1]; ++run) {
        const auto first = static_cast<std::size_t>(list.runs[run].first);
        const auto count = static_cast<std::size_t>(list.runs[run].count);
        for (std::size_t other = first; other < first + count; ++other, ++mask) {
            for (std::size_t lane = 0; lane < cluster_size; ++lane) f(mask, other * cluster_size + lane);
        }
    }
}

namespace detail {

/// Positions of the set bits of each byte, in order.
constexpr std::array<std::array<std::uint8_t, 8>, 256> bit_positions() {
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (std::size_t mask = 0; mask < 256; ++mask) {
        std::size_t n = 0;
        for (std::size_t bit = 0; bit < 8; ++bit) {
            if ((mask >> bit & 1U) != 0) table[mask][n++] = static_cast<std::uint8_t>(bit);
        }
    }
    return table;
}
inline constexpr auto bit_position_table = bit_positions();

}  // namespace detail

template <class Writer>
[[gnu::always_inline]] inline std::size_t NeighbourList::spell(std::size_t cluster, std::int32_t* slots,
                                                               const Writer& write) const {
    const std::uint8_t* mask = masks.data() + mask_begin[cluster];
    const ClusterRun* const end = runs.data() + run_begin[cluster + 1];
    std::int32_t* next = slots;
    for (const ClusterRun* run = runs.data() + run_begin[cluster]; run != end; ++run) {
        std::int32_t base = run->first * cluster_size;
        for (std::int32_t c = 0; c < run->count; ++c, base += cluster_size, ++mask) {
            write.bits(base, *mask, next);  // all eight: the next cluster overwrites the rest
            next += __builtin_popcount(*mask);
        }
    }
    for (std::size_t l = 0; l < lookahead; l += cluster_size) write.same(empty_slot, next + l);
    return static_cast<std::size_t>(next - slots);
}

inline std::size_t NeighbourList::spell(std::size_t cluster, std::int32_t* slots) const {
    struct {
        static void bits(std::int32_t base, std::uint8_t mask, std::int32_t* to) {
            for (const std::uint8_t position : detail::bit_position_table[mask]) *to++ = base + position;
        }
        static void same(std::int32_t value, std::int32_t* to) { std::fill_n(to, cluster_size, value); }
    } const plain;
    return spell(cluster, slots, plain);
}

/// What a search writes for a block of i-clusters. Plain arrays that grow through functions outside of the
/// instruction sets' objects, which must not bring their own copies of library code into the binary.
class NeighbourBlock {
  public:
    /// Make room for `runs` more runs and `masks` more masks.
    void reserve(std::size_t runs, std::size_t masks) {
        if (runs_.size() < run_count_ + runs || masks_.size() < mask_count_ + masks) grow(runs, masks);
    }
    /// Empty, with the memory that it has.
    void clear();
    /// The same content in no more memory than it needs.
    [[nodiscard]] NeighbourBlock trimmed() const;
    void add_run(ClusterRun run) { runs_[run_count_++] = run; }
    void add_mask(std::uint8_t mask) { masks_[mask_count_++] = mask; }
    /// `count` masks, the first in the lowest bits; there must be room for 8.
    void add_masks(std::uint64_t masks, std::size_t count) {
        __builtin_memcpy(&masks_[mask_count_], &masks, sizeof(masks));
        mask_count_ += count;
    }
    [[nodiscard]] std::size_t run_count() const { return run_count_; }
    [[nodiscard]] std::size_t mask_count() const { return mask_count_; }
    [[nodiscard]] const std::vector<ClusterRun>& runs() const { return runs_; }
    [[nodiscard]] const std::vector<std::uint8_t>& masks() const { return masks_; }

    static constexpr std::size_t size = 32;           ///< most i-clusters of a block
    std::array<std::uint32_t, size> cluster_runs{};   ///< by i-cluster of the block
    std::array<std::uint32_t, size> cluster_masks{};  ///< by i-cluster of the block
    std::size_t largest = 0;
    std::size_t neighbours = 0;

  private:
    void grow(std::size_t runs, std::size_t masks);

    std::vector<ClusterRun> runs_;
    std::vector<std::uint8_t> masks_;
    std::size_t run_count_ = 0;
    std::size_t mask_count_ = 0;
};

/// Both sides of a search.
template <int D>
struct NeighbourSearch {
    const Clusters<D>* i = nullptr;
    const Clusters<D>* j = nullptr;
    const FixedPoint<D>* fixed_point = nullptr;
    double range = 0.0;  ///< m, with the margin for rounding
};

/// The search for i-clusters [begin, end); one per instruction set (neighbour_search.hpp).
template <int D>
using NeighbourSearchFunction = void (*)(const NeighbourSearch<D>&, std::size_t begin, std::size_t end,
                                         NeighbourBlock& block);

/// Build the list of j-slots within `range` (m) of each i-cluster. i and j may be the same clusters; a
/// particle is then its own neighbour (all pair terms vanish at zero distance). Both were built on the same
/// domain.
template <int D>
[[nodiscard]] NeighbourList build_neighbour_list(const Clusters<D>& i_clusters, const Clusters<D>& j_clusters,
                                                 const FixedPoint<D>& fixed_point, double range);

}  // namespace riffle::inline sph
