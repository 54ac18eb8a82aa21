#pragma once

// Between the records of a cluster, one after the other in memory, and lanes, one array per field. Compiled
// per instruction set.

#include <cstring>

#include "sph/wide.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

/// Numbers of the size of `Real` in a record, padding included.
template <class Record, class Real>
inline constexpr std::size_t record_words = sizeof(Record) / sizeof(Real);

/// The words of the 8 records of a cluster, one array of lanes per word. Integers keep their bits.
template <class Record, class Real>
using RecordLanes = std::array<Lanes<Real>, record_words<Record, Real>>;

/// Bits of 32-bit integers in lanes of single-precision words, and back. In double precision a word holds two
/// integers, so records are taken apart field by field there.
#ifdef __AVX2__
RIFFLE_INLINE Lanes<float> words_of(const Lanes<std::int32_t>& v) {
    return Lanes<float>(_mm256_castsi256_ps(static_cast<__m256i>(v)));
}
RIFFLE_INLINE Lanes<std::int32_t> integers_of(const Lanes<float>& v) {
    return Lanes<std::int32_t>(_mm256_castps_si256(static_cast<__m256>(v)));
}

/// 8 x 8 words.
struct Words8x8 {
    __m256 row[8];  // NOLINT(*-avoid-c-arrays): std::array drops the attributes of the register type
};

/// Transpose 8 x 8 words: lane l of word w becomes lane w of row l.
RIFFLE_INLINE void transpose(Words8x8& words) {
    __m256* r = words.row;
    Words8x8 first;
    __m256* a = first.row;
    for (std::size_t n = 0; n < 8; n += 2) {
        a[n] = _mm256_unpacklo_ps(r[n], r[n + 1]);
        a[n + 1] = _mm256_unpackhi_ps(r[n], r[n + 1]);
    }
    Words8x8 second;
    __m256* b = second.row;
    for (std::size_t n = 0; n < 8; n += 4) {
        b[n] = _mm256_shuffle_ps(a[n], a[n + 2], 0x44);
        b[n + 1] = _mm256_shuffle_ps(a[n], a[n + 2], 0xee);
        b[n + 2] = _mm256_shuffle_ps(a[n + 1], a[n + 3], 0x44);
        b[n + 3] = _mm256_shuffle_ps(a[n + 1], a[n + 3], 0xee);
    }
    for (std::size_t n = 0; n < 4; ++n) {
        r[n] = _mm256_permute2f128_ps(b[n], b[n + 4], 0x20);
        r[n + 4] = _mm256_permute2f128_ps(b[n], b[n + 4], 0x31);
    }
}
#endif

/// Whether records of this type go through registers: single precision, whole groups of four words.
template <class Record, class Real>
constexpr bool records_in_registers() {
#ifdef __AVX2__
    return std::is_same_v<Real, float> && record_words<Record, Real> % 4 == 0;
#else
    return false;
#endif
}

/// Write the 8 records of a cluster.
template <class Record>
RIFFLE_INLINE void store_records(const RecordLanes<Record, float>& words, Record* records) {
#ifdef __AVX2__
    constexpr std::size_t count = record_words<Record, float>;
    for (std::size_t w = 0; w < count; w += 8) {
        Words8x8 rows;
        for (std::size_t n = 0; n < 8; ++n) {
            rows.row[n] =
                w + n < count ? static_cast<__m256>(words[w + n < count ? w + n : 0]) : _mm256_setzero_ps();
        }
        transpose(rows);
        for (std::size_t l = 0; l < 8; ++l) {
            float* row = reinterpret_cast<float*>(records + l) + w;
            if (w + 8 <= count) {
                _mm256_storeu_ps(row, rows.row[l]);
            } else {
                _mm_storeu_ps(row, _mm256_castps256_ps128(rows.row[l]));
            }
        }
    }
#else
    (void)words;
    (void)records;
#endif
}

/// Read the 8 records of a cluster.
template <class Record>
RIFFLE_INLINE RecordLanes<Record, float> load_records(const Record* records) {
    RecordLanes<Record, float> words;
#ifdef __AVX2__
    constexpr std::size_t count = record_words<Record, float>;
    for (std::size_t w = 0; w < count; w += 8) {
        Words8x8 rows;
        for (std::size_t l = 0; l < 8; ++l) {
            const float* row = reinterpret_cast<const float*>(records + l) + w;
            rows.row[l] = w + 8 <= count ? _mm256_loadu_ps(row) : _mm256_castps128_ps256(_mm_loadu_ps(row));
        }
        transpose(rows);
        for (std::size_t n = 0; n < 8 && w + n < count; ++n) words[w + n] = Lanes<float>(rows.row[n]);
    }
#else
    (void)records;
#endif
    return words;
}

/// The same 8 values in each half.
template <class Value, class Real>
RIFFLE_INLINE WideOf<Value, Real> both_halves(const Lanes<Value>& v) {
    if constexpr (neighbours_per_turn<Real> == 1) {
        return stdx::static_simd_cast<WideOf<Value, Real>>(v);
    } else {
#ifdef __AVX512F__
        if constexpr (std::is_same_v<Value, float>) {
            return WideOf<Value, Real>(_mm512_broadcast_f32x8(static_cast<__m256>(v)));
        } else {
            return WideOf<Value, Real>(_mm512_broadcast_i32x8(static_cast<__m256i>(v)));
        }
#endif
    }
}

}  // namespace riffle::inline sph::RIFFLE_ISA
