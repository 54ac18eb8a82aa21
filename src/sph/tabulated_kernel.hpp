#pragma once

// Compiled once per instruction set, like pair_loops_impl.hpp.

#include "sph/kernel_table.hpp"
#include "sph/wide.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

/// One coefficient per lane, that of the lane's piece. In single precision the pieces fit into a register,
/// and one permutation picks them.
template <class Real>
RIFFLE_INLINE Wide<Real> pick(const std::array<Real, KernelTable<Real>::stored>& coefficients,
                              const WideInteger<Real>& piece) {
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<Real, float>) {
        return Wide<Real>(
            _mm512_permutexvar_ps(static_cast<__m512i>(piece), _mm512_load_ps(coefficients.data())));
    }
#elif defined(__AVX2__)
    if constexpr (std::is_same_v<Real, float>) {
        return Wide<Real>(
            _mm256_permutevar8x32_ps(_mm256_load_ps(coefficients.data()), static_cast<__m256i>(piece)));
    }
#endif
    alignas(64) std::array<std::int32_t, Wide<Real>::size()> pieces;
    alignas(64) std::array<Real, Wide<Real>::size()> picked;
    piece.copy_to(pieces.data(), stdx::vector_aligned);
    for (std::size_t l = 0; l < picked.size(); ++l) {
        picked[l] = coefficients[static_cast<std::size_t>(pieces[l])];
    }
    return Wide<Real>(picked.data(), stdx::vector_aligned);
}

/// A kernel from its table, with the interface of those of kernel.hpp.
template <class Real>
struct TabulatedKernel {
    using W = Wide<Real>;
    const KernelTable<Real>& table;

    RIFFLE_INLINE W value(const W& q) const { return polynomial(table.value, q); }
    template <class R>
    static constexpr R gradient_constant() {
        return R(1);
    }
    RIFFLE_INLINE W gradient_shape(const W& q) const {
        // At q = 0 the slope vanishes; the tiny number only keeps the quotient finite.
        return polynomial(table.slope, q) / (q + Real(1e-12));
    }

  private:
    RIFFLE_INLINE static W polynomial(const typename KernelTable<Real>::Polynomials& coefficients,
                                      const W& q) {
        using Table = KernelTable<Real>;
        const W place = stdx::min(W(q * Table::pieces_per_length), W(Table::pieces));
        const auto piece = stdx::static_simd_cast<WideInteger<Real>>(place);
        const W t = Real(2) * (place - stdx::static_simd_cast<W>(piece)) - Real(1);
        W sum = pick<Real>(coefficients[Table::degree], piece);
        for (std::size_t k = Table::degree; k-- > 0;) sum = sum * t + pick<Real>(coefficients[k], piece);
        return sum;
    }
};

}  // namespace riffle::inline sph::RIFFLE_ISA
