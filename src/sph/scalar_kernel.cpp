#include "sph/scalar_kernel.hpp"

#include "sph/kernel_registry.hpp"

namespace riffle::inline sph {

template <int D>
ScalarKernel scalar_kernel(KernelKind kind) {
    return visit_kernel<D>(kind, [](auto kernel) {
        using Kernel = decltype(kernel);
        return ScalarKernel{.value = [](double q) { return Kernel::value(q); },
                            .gradient_factor = [](double q) { return Kernel::gradient_factor(q); }};
    });
}

template ScalarKernel scalar_kernel<2>(KernelKind);
template ScalarKernel scalar_kernel<3>(KernelKind);

}  // namespace riffle::inline sph
