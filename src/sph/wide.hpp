#pragma once

// Wide lanes of the pair loops, for the instruction set this is compiled for. A cluster's 8 particles fill 8
// lanes; where a register holds 16 single-precision numbers, two neighbours are treated at once, one in each
// half. Included once per instruction set, inside its namespace.

#include <array>
#include <cstdint>
#include <experimental/simd>

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "sph/lanes.hpp"
#include "sph/neighbour_list.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

namespace stdx = std::experimental;

/// Neighbours per turn of the pair loops.
template <class Real>
inline constexpr std::size_t neighbours_per_turn = stdx::native_simd<Real>::size() == 2 * cluster_size ? 2
                                                                                                       : 1;

/// One value per particle of the i-cluster and neighbour of the turn; half h belongs to neighbour h.
template <class Value, class Real>
using WideOf = std::conditional_t<
    stdx::native_simd<Value>::size() == cluster_size * neighbours_per_turn<Real>, stdx::native_simd<Value>,
    stdx::fixed_size_simd<Value, static_cast<int>(cluster_size* neighbours_per_turn<Real>)>>;

template <class Real>
using Wide = WideOf<Real, Real>;
template <class Real>
using WideInteger = WideOf<std::int32_t, Real>;

/// A value of neighbour a in the first half and of neighbour b in the second (a alone where there is one
/// half).
template <class Real, class Value>
RIFFLE_INLINE WideOf<Value, Real> halves(const Value& a, const Value& b) {
    if constexpr (neighbours_per_turn<Real> == 1) {
        (void)b;
        return WideOf<Value, Real>(a);
    } else {
#ifdef __AVX512F__
        constexpr __mmask16 second_half = 0xff00;
        if constexpr (std::is_same_v<Value, float>) {
            return WideOf<Value, Real>(
                _mm512_mask_broadcastss_ps(_mm512_set1_ps(a), second_half, _mm_load_ss(&b)));
        } else {
            return WideOf<Value, Real>(
                _mm512_mask_broadcastd_epi32(_mm512_set1_epi32(a), second_half, _mm_cvtsi32_si128(b)));
        }
#else
        static_assert(neighbours_per_turn<Real> == 1);
#endif
    }
}

/// Sum of the halves: what all neighbours add to each particle of the cluster.
template <class Real>
RIFFLE_INLINE Lanes<Real> fold(const Wide<Real>& v) {
    if constexpr (neighbours_per_turn<Real> == 2) {
#ifdef __AVX512F__
        // In registers: through memory the compiler would keep the sums of the loops in memory too.
        const auto whole = static_cast<__m512>(v);
        return Lanes<Real>(_mm256_add_ps(_mm512_castps512_ps256(whole), _mm512_extractf32x8_ps(whole, 1)));
#endif
    } else {
        return stdx::static_simd_cast<Lanes<Real>>(v);
    }
}

/// Bit h: whether any lane of half h is at most `limit`.
RIFFLE_INLINE unsigned any_in_halves(const Wide<float>& v, float limit) {
    if constexpr (neighbours_per_turn<float> == 2) {
#ifdef __AVX512F__
        const unsigned lanes = _mm512_cmp_ps_mask(static_cast<__m512>(v), _mm512_set1_ps(limit), _CMP_LE_OQ);
        return ((lanes & 0xffU) != 0 ? 1U : 0U) | (lanes > 0xffU ? 2U : 0U);
#endif
    } else {
        return stdx::any_of(v <= limit) ? 1U : 0U;
    }
}

/// Bit l: whether lane l is at most `limit`.
RIFFLE_INLINE unsigned lanes_at_most(const Lanes<float>& v, float limit) {
#ifdef __AVX2__
    return static_cast<unsigned>(
        _mm256_movemask_ps(_mm256_cmp_ps(static_cast<__m256>(v), _mm256_set1_ps(limit), _CMP_LE_OQ)));
#else
    unsigned bits = 0;
    for (std::size_t l = 0; l < cluster_size; ++l) bits |= (v[l] <= limit ? 1U : 0U) << l;
    return bits;
#endif
}

/// The positions of the bits of a mask in lanes, in order.
RIFFLE_INLINE Lanes<std::int32_t> bit_positions(std::uint8_t mask) {
    const std::uint8_t* positions = detail::bit_position_table[mask].data();
#ifdef __AVX2__
    return Lanes<std::int32_t>(
        _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(positions))));
#else
    return {positions, stdx::element_aligned};
#endif
}

/// One field of the 8 records of a cluster, in each half.
template <class Real, class Value, class Record, class Get>
RIFFLE_INLINE WideOf<Value, Real> gather(const Record* records, const Get& get) {
    alignas(64) std::array<Value, cluster_size * neighbours_per_turn<Real>> values;
    for (std::size_t l = 0; l < values.size(); ++l) values[l] = get(records[l % cluster_size]);
    return WideOf<Value, Real>(values.data(), stdx::vector_aligned);
}

}  // namespace riffle::inline sph::RIFFLE_ISA
