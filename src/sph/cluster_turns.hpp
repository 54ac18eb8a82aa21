#pragma once

// What the pair loops share: the i side of a cluster, the turns of its list, and sums over them. Compiled
// once per instruction set, like pair_loops_impl.hpp.

#include <algorithm>
#include <utility>

#include "sph/pair_loops.hpp"
#include "sph/pair_terms.hpp"
#include "sph/record_lanes.hpp"
#include "sph/tabulated_kernel.hpp"
#include "sph/wide.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

/// The i side of a cluster and what its turns need.
template <int D, class Real>
struct OwnCluster {
    Components<WideInteger<Real>, D> x;
    Components<Wide<Real>, D> u;

    template <class Record>
    RIFFLE_INLINE explicit OwnCluster(const Record* records) {
        for (std::size_t k = 0; k < D; ++k) {
            x[k] = gather<Real, std::int32_t>(records, [k](const Record& r) { return r.x[k]; });
            u[k] = gather<Real, Real>(records, [k](const Record& r) { return r.u[k]; });
        }
    }

    /// Of words in the order of MotionRecord and WallForceRecord: positions, then velocities.
    template <std::size_t N>
    RIFFLE_INLINE explicit OwnCluster(const std::array<Lanes<float>, N>& words) {
#ifdef __AVX2__
        for (std::size_t k = 0; k < D; ++k) {
            x[k] = both_halves<std::int32_t, Real>(integers_of(words[k]));
            u[k] = both_halves<Real, Real>(words[D + k]);
        }
#else
        (void)words;
#endif
    }

    /// r = x_i - x_j in smoothing lengths for the neighbours of a turn.
    template <class Record>
    RIFFLE_INLINE Components<Wide<Real>, D> distance(const Record& a, const Record& b,
                                                     const PairConstants<D, Real>& c) const {
        Components<Wide<Real>, D> r{};
        for (std::size_t k = 0; k < D; ++k) {
            const WideInteger<Real> difference = x[k] - halves<Real, std::int32_t>(a.x[k], b.x[k]);
            r[k] = stdx::static_simd_cast<Wide<Real>>(difference) * c.unit[k];
        }
        return r;
    }

    /// u_i - u_j.
    template <class Record>
    RIFFLE_INLINE Components<Wide<Real>, D> velocity(const Record& a, const Record& b) const {
        Components<Wide<Real>, D> difference{};
        for (std::size_t k = 0; k < D; ++k) difference[k] = u[k] - halves<Real, Real>(a.u[k], b.u[k]);
        return difference;
    }
};

/// The i side of a cluster from its motion records, and their density deviation.
template <int D, class Real>
RIFFLE_INLINE std::pair<OwnCluster<D, Real>, Wide<Real>> own_motion(const MotionRecord<D, Real>* records) {
    if constexpr (records_in_registers<MotionRecord<D, Real>, Real>()) {
        const auto words = load_records(records);
        return {OwnCluster<D, Real>(words), both_halves<Real, Real>(words[2 * D])};
    } else {
        return {OwnCluster<D, Real>(records), gather<Real, Real>(records, [](const auto& r) { return r.s; })};
    }
}

/// The stress and the viscosity root of a cluster.
template <class Real, class Record>
RIFFLE_INLINE auto own_stress(const Record* records) {
    constexpr std::size_t components = std::tuple_size_v<decltype(Record::stress)>;
    std::pair<Components<Wide<Real>, components>, Wide<Real>> own{};
    if constexpr (records_in_registers<Record, Real>()) {
        const auto words = load_records(records);
        for (std::size_t k = 0; k < components; ++k) own.first[k] = both_halves<Real, Real>(words[k]);
        own.second = both_halves<Real, Real>(words[components]);
    } else {
        for (std::size_t k = 0; k < components; ++k) {
            own.first[k] = gather<Real, Real>(records, [k](const auto& r) { return r.stress[k]; });
        }
        own.second = gather<Real, Real>(records, [](const auto& r) { return r.viscosity_root; });
    }
    return own;
}

template <std::size_t N, class T>
RIFFLE_INLINE void add(std::array<T, N>& sum, const std::array<T, N>& term) {
    for (std::size_t k = 0; k < N; ++k) sum[k] += term[k];
}

template <std::size_t N, class T>
RIFFLE_INLINE void subtract(std::array<T, N>& sum, const std::array<T, N>& term) {
    for (std::size_t k = 0; k < N; ++k) sum[k] -= term[k];
}

/// The folded sums times a factor.
template <class Real, std::size_t N>
RIFFLE_INLINE std::array<Lanes<Real>, N> fold_all(const std::array<Wide<Real>, N>& sums, Real factor) {
    std::array<Lanes<Real>, N> result{};
    for (std::size_t k = 0; k < N; ++k) result[k] = fold<Real>(sums[k]) * factor;
    return result;
}

/// NeighbourList::spell()'s writer in lanes.
struct LaneWriter {
    RIFFLE_INLINE static void bits(std::int32_t base, std::uint8_t mask, std::int32_t* to) {
        store_lanes(Lanes<std::int32_t>(Lanes<std::int32_t>(base) + bit_positions(mask)), to);
    }
    RIFFLE_INLINE static void same(std::int32_t value, std::int32_t* to) {
        store_lanes(Lanes<std::int32_t>(value), to);
    }
};

/// Call f(slot_a, slot_b, ahead) for the turns of a cluster's list; `ahead` is a slot of a later turn, to
/// fetch.
template <class Real, class F>
RIFFLE_INLINE void for_turns(const NeighbourList& list, std::size_t cluster, std::int32_t* slots,
                             const F& f) {
    const std::size_t count = list.spell(cluster, slots, LaneWriter{});
    for (std::size_t n = 0; n < count; n += neighbours_per_turn<Real>) {
        f(static_cast<std::size_t>(slots[n]),
          static_cast<std::size_t>(slots[n + neighbours_per_turn<Real> - 1]),
          &slots[n + NeighbourList::lookahead]);
    }
}

/// Fetch the records of the turn that `ahead` points to.
template <class Real, class Record>
RIFFLE_INLINE void prefetch(const std::vector<Record>& records, const std::int32_t* ahead) {
    for (std::size_t n = 0; n < neighbours_per_turn<Real>; ++n) {
        const char* record = reinterpret_cast<const char*>(records.data() + ahead[n]);
        __builtin_prefetch(record);
        if constexpr (sizeof(Record) > 64) __builtin_prefetch(record + 64);
    }
}

/// A kernel with what it needs of the constants.
template <class Kernel, int D, class Real>
RIFFLE_INLINE Kernel kernel_of(const PairConstants<D, Real>& c) {
    if constexpr (std::is_same_v<Kernel, TabulatedKernel<Real>>) {
        return {*c.table};
    } else {
        static_cast<void>(c);
        return {};
    }
}

/// The records of the stress in a form.
template <class Record, int D, class Real>
RIFFLE_INLINE const std::vector<Record>& stress_records(const PairData<D, Real>& data) {
    if constexpr (std::is_same_v<Record, PressureRecord<Real>>) {
        return data.pressure;
    } else {
        return data.stress;
    }
}

}  // namespace riffle::inline sph::RIFFLE_ISA
