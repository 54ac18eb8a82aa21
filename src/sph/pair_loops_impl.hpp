#pragma once

// The tables of the loops. This header, with those of the loops, is compiled once per instruction set, inside
// a namespace of its own (RIFFLE_ISA), so that the linker never mixes their code.
//
// Distances are measured in smoothing lengths, and the constant factors of a sum (the kernel's constant,
// powers of h) multiply the sum, not each of its terms.

#include "sph/force_loop.hpp"
#include "sph/gradient_loop.hpp"
#include "sph/moment_loops.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

template <int D, class Real, class Kernel, class Record>
PairLoops<D, Real> loops_of(const LoopOptions& options) {
    constexpr bool gradients = std::is_same_v<Record, StressRecord<D, Real>>;
    PairLoops<D, Real> loops{};
    loops.gradient = &gradient_loop<D, Real, Kernel, gradients, false>;
    loops.gradient_midway = &gradient_loop<D, Real, Kernel, gradients, true>;
    loops.force = &force_loop<D, Real, Kernel, PairForm<Real>, Record>;
    if constexpr (!std::is_same_v<Kernel, TabulatedKernel<Real>>) {
        if (!needs_pair_form(options)) {
            loops.force = &force_loop<D, Real, Kernel, MorrisViscosity, Record>;
            if constexpr (D == 3 && gradients) {
                if (options.directional) {
                    loops.force = &force_loop<D, Real, Kernel, DirectionalViscosity<Real>, Record>;
                }
            }
        }
    }
    loops.wall = &wall_loop<D, Real, Kernel, Record>;
    loops.filter = &filter_loop<D, Real, Kernel>;
    return loops;
}

template <int D, class Real, class Kernel>
PairLoops<D, Real> loops_with(const LoopOptions& options) {
    return options.gradients ? loops_of<D, Real, Kernel, StressRecord<D, Real>>(options)
                             : loops_of<D, Real, Kernel, PressureRecord<Real>>(options);
}

template <int D, class Real>
PairLoops<D, Real> loops(const LoopOptions& options) {
    static_assert(has_own_loops(KernelKind::wendland_c2) && has_own_loops(KernelKind::cubic_spline));
    return options.kernel == KernelKind::wendland_c2    ? loops_with<D, Real, WendlandC2<D>>(options)
           : options.kernel == KernelKind::cubic_spline ? loops_with<D, Real, CubicSpline<D>>(options)
                                                        : loops_with<D, Real, TabulatedKernel<Real>>(options);
}

}  // namespace riffle::inline sph::RIFFLE_ISA
