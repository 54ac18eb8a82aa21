#pragma once

#include <stdexcept>

#include "case/options.hpp"
#include "sph/further_kernels.hpp"
#include "sph/kernel.hpp"

namespace riffle::inline sph {

/// Call `f` with the kernel of a case's choice in D dimensions: `f(WendlandC2<D>{})`, ... All calls must
/// return the same type. The one place where a kernel is registered.
template <int D, class F>
decltype(auto) visit_kernel(KernelKind kind, const F& f) {
    switch (kind) {
        case KernelKind::wendland_c2:
            return f(WendlandC2<D>{});
        case KernelKind::cubic_spline:
            return f(CubicSpline<D>{});
        case KernelKind::gaussian:
            return f(Gaussian<D>{});
        case KernelKind::quadratic:
            return f(Quadratic<D>{});
        case KernelKind::quintic_spline:
            return f(QuinticSpline<D>{});
        case KernelKind::wendland_c4:
            return f(WendlandC4<D>{});
        case KernelKind::wendland_c6:
            return f(WendlandC6<D>{});
    }
    throw std::logic_error("a kernel that kernel_registry.hpp does not list");
}

}  // namespace riffle::inline sph
