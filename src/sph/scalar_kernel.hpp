#pragma once

#include "case/options.hpp"

namespace riffle::inline sph {

/// A kernel in double precision for sums outside the pair loops: for q = r/h, h^D W and h^(D+2) F of
/// kernel.hpp.
struct ScalarKernel {
    double (*value)(double q) = nullptr;
    double (*gradient_factor)(double q) = nullptr;
};

/// The kernel of a case's choice in D dimensions.
template <int D>
[[nodiscard]] ScalarKernel scalar_kernel(KernelKind kind);

}  // namespace riffle::inline sph
