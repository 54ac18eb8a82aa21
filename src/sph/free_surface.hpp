#pragma once

#include <array>
#include <span>
#include <vector>

#include "case/options.hpp"
#include "particles/domain.hpp"
#include "particles/joined_values.hpp"

namespace riffle::inline sph {

/// The particles of the bed and of the solids that stand in the water.
template <int D>
struct SolidParticles {
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;  ///< m
    std::vector<double> volume;                                             ///< m2 in 2D, m3 in 3D
};

/// The fluid particles that a surface is looked for in, D = 2 or 3; the last axis is the vertical one.
template <int D>
struct FluidParticles {
    Domain<D> domain;
    std::array<JoinedValues, static_cast<std::size_t>(D)> position;  ///< m
    std::span<const double> volume;                                  ///< m2 in 2D, m3 in 3D
    KernelKind kernel = KernelKind::wendland_c2;
    double smoothing_length = 0.0;  ///< h, m
    SolidParticles<D> solids = {};  ///< what takes the room of water beside and below a place
};

// Each of these gives the elevation of the free surface (m, on the axis of the domain) over each horizontal
// position of `at`; not-a-number where no water is found. How far they are off: docs/free-surface.md. The
// first two reckon with bed and solids: the sum of a place counts them as water as far as they stand below
// it, for the rest of what lies below a level surface is water. Water makes half of the sum at least, and a
// place inside a solid is dry.

/// By the divergence of the position (thesis 2.60): -sum V_j r_ij.grad W falls from D inside the water to 0
/// outside, and to D/2 on the surface itself. Scanned from above to `threshold`; the thesis' 1.4 in 2D lies
/// 0.5 h below the surface.
template <int D>
[[nodiscard]] std::vector<double> surface_by_position_divergence(const FluidParticles<D>& fluid,
                                                                 std::span<const Vec<D - 1>> at,
                                                                 double threshold);

/// By the contour of the volume fraction sum V_j W(r - r_j), 1 inside the water, 1/2 on its surface. Scanned
/// from above to `threshold`.
template <int D>
[[nodiscard]] std::vector<double> surface_by_volume_fraction(const FluidParticles<D>& fluid,
                                                             std::span<const Vec<D - 1>> at,
                                                             double threshold);

/// By the density ratio of the particles (Koshizuka, Nobe & Oka 1998, with the kernel's sum for the number
/// density): those with rho_a/rho0 = sum V_b W_ab < `ratio` (0.8-0.99 in the literature) are of the surface.
/// The highest of them within one spacing of the place: a particle's centre, so half a spacing below the
/// surface.
template <int D>
[[nodiscard]] std::vector<double> surface_by_density_ratio(const FluidParticles<D>& fluid,
                                                           std::span<const Vec<D - 1>> at, double ratio);

/// By the depth of the water column (Tis Isat; thesis chapter 2, its printed form mended): sum V_j W(|x -
/// x_j|) with the kernel of D - 1 dimensions, above `bed_level`. It has the water's volume exactly; it knows
/// nothing of where in the column the water is, so drops, voids and overhangs count as depth, and what lies
/// below the bed level among roughness elements does, too.
template <int D>
[[nodiscard]] std::vector<double> surface_by_depth_sum(const FluidParticles<D>& fluid,
                                                       std::span<const Vec<D - 1>> at,
                                                       double bed_level = 0.0);

/// The surface by one of these ways; the depth sum has no threshold.
template <int D>
[[nodiscard]] std::vector<double> find_surface(SurfaceDetection detection, double threshold,
                                               const FluidParticles<D>& fluid,
                                               std::span<const Vec<D - 1>> at);

}  // namespace riffle::inline sph
