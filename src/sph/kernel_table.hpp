#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "case/options.hpp"

namespace riffle::inline sph {

/// Whether the pair loops are compiled for a kernel; they take all others from a table.
[[nodiscard]] constexpr bool has_own_loops(KernelKind kind) {
    return kind == KernelKind::wendland_c2 || kind == KernelKind::cubic_spline;
}

/// A kernel as polynomials of degree 7 on equal pieces of its radius, W and dW/dq for h = 1: one type for the
/// pair loops, whatever the kernel. With six pieces all knots of the splines lie between pieces, and the
/// error is below the rounding of single precision (KernelTable.* of tests/unit/sph/kernel_test.cpp); double
/// precision takes 48. Polynomials are of t in [-1, 1] on the piece; beyond the radius they vanish.
template <class Real>
struct KernelTable {
    static constexpr int pieces = std::is_same_v<Real, float> ? 6 : 48;
    static constexpr std::size_t degree = 7;
    /// Pieces and at least one of zeros; eight of them fill a register of AVX2, sixteen one of AVX-512.
    static constexpr std::size_t stored = std::is_same_v<Real, float> ? 16 : 56;
    static constexpr Real pieces_per_length = Real(pieces) / Real(2);

    /// Coefficients of t^k by piece, at [k][piece].
    using Polynomials = std::array<std::array<Real, stored>, degree + 1>;
    alignas(64) Polynomials value;
    alignas(64) Polynomials slope;
};

/// The table of a kernel in D dimensions; it lives as long as the program.
template <int D, class Real>
[[nodiscard]] const KernelTable<Real>& kernel_table(KernelKind kind);

}  // namespace riffle::inline sph
