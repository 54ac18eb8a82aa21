#pragma once

#include <stdexcept>

#include "case/case.hpp"
#include "sph/kernel.hpp"

namespace riffle {

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
        case KernelKind::quadratic:
        case KernelKind::quintic_spline:
        case KernelKind::wendland_c4:
        case KernelKind::wendland_c6:
            break;
    }
    throw std::logic_error("a kernel that kernel_registry.hpp does not list");
}

}  // namespace riffle
