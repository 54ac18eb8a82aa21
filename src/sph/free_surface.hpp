#pragma once

#include <span>
#include <vector>

#include "case/case.hpp"
#include "particles/domain.hpp"

namespace riffle {

/// Elevation of the free surface (m above the bed level) over each x, by the divergence of the position
/// (thesis 2.60): -sum V_j r_ij.grad W falls from D inside the water to 0 outside, and to D/2 on the surface
/// itself, which is the threshold used here (the thesis' 1.4 in 2D lies 0.5 h below it). Scanned from above.
/// NaN where no water is found. `position`, `volume`: of the fluid particles.
[[nodiscard]] std::vector<double> surface_elevation(const Domain<2>& domain,
                                                    std::span<const double> position_x,
                                                    std::span<const double> position_z,
                                                    std::span<const double> volume, KernelKind kernel,
                                                    double smoothing_length, std::span<const double> x);

}  // namespace riffle
