#pragma once

// The search for neighbours. Compiled once per instruction set, like the loops.

#include <cmath>
#include <limits>

#include "sph/neighbour_list.hpp"
#include "sph/wide.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

/// Columns of the j side that the interval [low, high] touches along one axis, each once.
class ColumnRange {
  public:
    ColumnRange() = default;
    template <int D>
    ColumnRange(const Clusters<D>& j, std::size_t axis, double low, double high)
        : columns_(j.columns[axis]), periodic_(j.periodic[axis]) {
        const int first = static_cast<int>(std::floor((low - j.lower[axis]) / j.column_width[axis]));
        const int last = static_cast<int>(std::floor((high - j.lower[axis]) / j.column_width[axis]));
        if (periodic_) {
            first_ = first;
            while (first_ < 0) first_ += columns_;
            while (first_ >= columns_) first_ -= columns_;
            count_ = last - first + 1 < columns_ ? last - first + 1 : columns_;
        } else {
            first_ = first < 0 ? 0 : (first < columns_ ? first : columns_ - 1);
            const int end = last < 0 ? 0 : (last < columns_ ? last : columns_ - 1);
            count_ = end - first_ + 1;
        }
    }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] int operator[](int n) const {
        const int column = first_ + n;
        return periodic_ && column >= columns_ ? column - columns_ : column;
    }

  private:
    int columns_ = 1;
    bool periodic_ = false;
    int first_ = 0;
    int count_ = 1;
};

/// Bit l: whether lane l is at most `limit`.
template <class V>
RIFFLE_INLINE unsigned wide_at_most(const V& v, float limit) {
    if constexpr (V::size() == 2 * cluster_size) {
#ifdef __AVX512F__
        return _mm512_cmp_ps_mask(static_cast<__m512>(v), _mm512_set1_ps(limit), _CMP_LE_OQ);
#endif
    } else {
        return lanes_at_most(v, limit);
    }
}

/// The search of one block, with its constants and buffers.
template <int D>
class BlockSearch {
  public:
    BlockSearch(const NeighbourSearch<D>& search, NeighbourBlock& block)
        : i_(*search.i),
          j_(*search.j),
          fixed_point_(*search.fixed_point),
          block_(block),
          range_(search.range) {
        range_squared_ = static_cast<float>(range_ * range_);
        for (std::size_t k = 0; k < D; ++k) unit_[k] = static_cast<float>(fixed_point_.unit(k));
        reach_ = static_cast<std::int64_t>(std::ceil(range_ / fixed_point_.unit(D - 1))) + 2;
    }

    void search_cluster(std::size_t ci, std::size_t place) {
        const std::size_t runs_before = block_.run_count();
        const std::size_t masks_before = block_.mask_count();
        neighbours_ = 0;
        const std::int64_t centre = i_.centre[D - 1][ci];
        const auto half = static_cast<std::int64_t>(static_cast<double>(i_.half_extent[D - 1][ci]) /
                                                    fixed_point_.unit(D - 1)) +
                          2;
        low_ = centre - half - reach_;
        high_ = centre + half + reach_;
        if (j_.periodic[D - 1] || low_ <= j_.top) search_columns(ci);
        block_.cluster_runs[place] = static_cast<std::uint32_t>(block_.run_count() - runs_before);
        block_.cluster_masks[place] = static_cast<std::uint32_t>(block_.mask_count() - masks_before);
        block_.neighbours += neighbours_;
        block_.largest = block_.largest > neighbours_ ? block_.largest : neighbours_;
    }

  private:
    void search_columns(std::size_t ci) {
        take_positions(ci);
        std::array<ColumnRange, 2> columns;
        for (std::size_t k = 0; k + 1 < D; ++k) {
            const double centre = fixed_point_.decode(i_.centre[k][ci], k);
            const double reach = static_cast<double>(i_.half_extent[k][ci]) + range_;
            columns[k] = ColumnRange(j_, k, centre - reach, centre + reach);
        }
        const auto stride = static_cast<std::size_t>(D == 3 ? j_.columns[D - 2] : 1);
        for (int x = 0; x < columns[0].count(); ++x) {
            for (int y = 0; y < columns[1].count(); ++y) {
                search_column(ci, static_cast<std::size_t>(columns[0][x]) * stride +
                                      static_cast<std::size_t>(columns[1][y]));
            }
        }
    }

    /// The positions of the i-cluster.
    void take_positions(std::size_t ci) {
        image_ = true;
        Lanes<float> squared(0.0F);
        for (std::size_t k = 0; k < D; ++k) {
            const std::int32_t* code = &i_.slot_position[k][ci * cluster_size];
            const Lanes<std::int32_t> offset = load_lanes(code) - i_.centre[k][ci];
            const Lanes<float> x = stdx::static_simd_cast<Lanes<float>>(offset) * unit_[k];
            squared += x * x;
            store_lanes(Lanes<float>(-2.0F * x), minus_twice_[k].data());
            constexpr double half_period = 2147483648.0;  // units
            // The rounding of near_image() grows with the square of a cluster's extent, of 8 drops in the air
            // say, and must stay below the margin of the range (build_neighbour_list).
            constexpr double widest = 4.0;
            const auto half = static_cast<double>(i_.half_extent[k][ci]);
            image_ = image_ &&
                     (!j_.periodic[k] || half + range_ < 0.999 * half_period * fixed_point_.unit(k)) &&
                     half < widest * range_;
        }
        store_lanes(squared, from_centre_squared_.data());
        // Else GCC keeps them in registers and takes them apart with two shuffles for each lane and use,
        // where a broadcast from memory is part of the multiplication.
        asm volatile("" : : "r"(this) : "memory");
        if (!image_) {
            for (std::size_t k = 0; k < D; ++k) {
                position_[k] = gather<float, std::int32_t>(&i_.slot_position[k][ci * cluster_size],
                                                           [](const std::int32_t& code) { return code; });
            }
        }
    }

    /// The clusters of one column: one run, from the first near cluster to the last.
    void search_column(std::size_t ci, std::size_t column) {
        auto first = static_cast<std::size_t>(j_.column_begin[column]);
        const auto last = static_cast<std::size_t>(j_.column_begin[column + 1]);
        const bool sorted = !j_.periodic[D - 1];
        if (sorted) {
            if (first == last || j_.highest[last - 1] < low_) return;
            // The first cluster that reaches up to low_, by bisection in high columns.
            std::size_t count = last - first;
            while (count > std::size_t{2} * cluster_size) {
                const std::size_t half_count = count / 2;
                const bool below = j_.highest[first + half_count] < low_;
                first = below ? first + half_count + 1 : first;
                count = below ? count - half_count - 1 : half_count;
            }
        }
        block_.reserve((last - first) / ClusterRun::longest + 1, last - first + cluster_size);
        std::size_t run_first = 0;
        std::size_t next = 0;  // the cluster that follows the run; 0: no run yet
        for (std::size_t group = first; group < last && !(sorted && j_.lowest[group] > high_);
             group += cluster_size) {
            unsigned candidates = near(ci, group);
            std::uint64_t present = read_bytes(&j_.present[group]);
            if (last - group < cluster_size) {
                candidates &= (1U << (last - group)) - 1U;
                present &= (std::uint64_t{1} << 8 * (last - group)) - 1U;
            }
            if (candidates == 0) continue;
            const std::uint64_t masks = masks_of(ci, group, candidates) & present;
            if (masks == 0) continue;
            const auto begin = static_cast<std::size_t>(__builtin_ctzll(masks)) / 8;
            const auto end = 8 - static_cast<std::size_t>(__builtin_clzll(masks)) / 8;
            if (next == 0) {
                run_first = group + begin;
                next = run_first;
            }
            for (; next < group + begin; ++next) block_.add_mask(0);
            block_.add_masks(masks >> 8 * begin, end - begin);
            next = group + end;
            neighbours_ += static_cast<std::size_t>(__builtin_popcountll(masks));
        }
        for (; run_first < next; run_first += ClusterRun::longest) {
            const std::size_t count =
                next - run_first < ClusterRun::longest ? next - run_first : ClusterRun::longest;
            ClusterRun run;
            run.first = static_cast<std::uint32_t>(run_first) & (ClusterRun::most_clusters - 1);
            run.count = static_cast<std::uint32_t>(count) & ClusterRun::longest;
            block_.add_run(run);
        }
    }

    /// 8 bytes as one number, the first lowest.
    static std::uint64_t read_bytes(const std::uint8_t* bytes) {
        std::uint64_t value = 0;
        __builtin_memcpy(&value, bytes, sizeof(value));
        return value;
    }

    /// Bit l: whether the boxes of clusters ci and cj + l come within range. Clusters past the last one too.
    [[nodiscard]] unsigned near(std::size_t ci, std::size_t cj) const {
        using Floats = Lanes<float>;
        using stdx::abs;
        Floats squared(0.0F);
        for (std::size_t k = 0; k < D; ++k) {
            const Lanes<std::int32_t> difference = i_.centre[k][ci] - load_lanes(&j_.centre[k][cj]);
            const Floats distance = abs(Floats(stdx::static_simd_cast<Floats>(difference) * unit_[k]));
            const auto gap =
                positive_part<Floats>(distance - i_.half_extent[k][ci] - load_lanes(&j_.half_extent[k][cj]));
            squared += gap * gap;
        }
        return lanes_at_most(squared, range_squared_);
    }

    /// For the candidates among clusters cj to cj + 7, a byte each, the slots that are within range of any
    /// particle of the i-cluster; clusters beside a candidate may have bits too.
    [[nodiscard]] std::uint64_t masks_of(std::size_t ci, std::size_t cj, unsigned candidates) const {
        std::uint64_t masks = 0;
        for (std::size_t c = 0; c < cluster_size; c += neighbours_per_turn<float>) {
            constexpr unsigned both = (1U << neighbours_per_turn<float>)-1U;
            if ((candidates >> c & both) != 0) {
                const unsigned near = image_ ? near_image(ci, cj + c) : near_images(cj + c);
                masks |= std::uint64_t{near} << 8 * c;
            }
        }
        return masks;
    }

    /// Bits of the slots of as many clusters from cj on as fill the lanes: whether they are within range of
    /// any particle of the i-cluster, where one image of each decides, that nearest to the cluster's centre,
    /// and the cluster is not wide.
    [[nodiscard]] unsigned near_image(std::size_t ci, std::size_t cj) const {
        std::array<Wide<float>, static_cast<std::size_t>(D)> x{};
        Wide<float> own_squared(0.0F);
        for (std::size_t k = 0; k < D; ++k) {
            const WideInteger<float> code(&j_.slot_position[k][cj * cluster_size], stdx::element_aligned);
            x[k] =
                stdx::static_simd_cast<Wide<float>>(WideInteger<float>(code - i_.centre[k][ci])) * unit_[k];
            own_squared += x[k] * x[k];
        }
        // |x_j - x_i|^2 - |x_j|^2, the least of all i.
        Wide<float> closest(std::numeric_limits<float>::max());
        for (std::size_t l = 0; l < cluster_size; ++l) {
            Wide<float> squared(from_centre_squared_[l]);
            for (std::size_t k = 0; k < D; ++k) squared += minus_twice_[k][l] * x[k];
            closest = stdx::min(closest, squared);
        }
        return wide_at_most(Wide<float>(closest + own_squared), range_squared_);
    }

    /// The same by the nearest image of each pair, in a narrow periodic domain.
    [[nodiscard]] unsigned near_images(std::size_t cj) const {
        unsigned mask = 0;
        for (std::size_t l = 0; l < cluster_size * neighbours_per_turn<float>;
             l += neighbours_per_turn<float>) {
            Wide<float> squared(0.0F);
            for (std::size_t k = 0; k < D; ++k) {
                const std::int32_t* code = &j_.slot_position[k][cj * cluster_size + l];
                const Wide<float> d =
                    stdx::static_simd_cast<Wide<float>>(WideInteger<float>(
                        position_[k] -
                        halves<float, std::int32_t>(code[0], code[neighbours_per_turn<float> - 1]))) *
                    unit_[k];
                squared += d * d;
            }
            mask |= any_in_halves(squared, range_squared_) << l;
        }
        return mask;
    }

    const Clusters<D>& i_;
    const Clusters<D>& j_;
    const FixedPoint<D>& fixed_point_;
    NeighbourBlock& block_;
    double range_;
    float range_squared_ = 0.0F;
    std::int64_t reach_ = 0;  ///< range in units of the last axis
    std::int64_t low_ = 0;    ///< what the i-cluster and its range span along the last axis, units
    std::int64_t high_ = 0;
    std::array<float, static_cast<std::size_t>(D)> unit_{};
    /// Of the i-cluster: whether one image decides, minus twice the positions from its centre (m) and their
    /// squared distances, positions in units where needed.
    bool image_ = true;
    std::array<std::array<float, cluster_size>, static_cast<std::size_t>(D)> minus_twice_{};
    std::array<float, cluster_size> from_centre_squared_{};
    std::array<WideInteger<float>, static_cast<std::size_t>(D)> position_{};
    std::size_t neighbours_ = 0;
};

template <int D>
[[gnu::flatten]] void search_neighbours(const NeighbourSearch<D>& search, std::size_t begin, std::size_t end,
                                        NeighbourBlock& block) {
    BlockSearch<D> one(search, block);
    for (std::size_t ci = begin; ci < end; ++ci) one.search_cluster(ci, ci - begin);
}

}  // namespace riffle::inline sph::RIFFLE_ISA
