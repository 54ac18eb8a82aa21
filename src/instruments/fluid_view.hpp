#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "case/case.hpp"
#include "instruments/particle_cells.hpp"
#include "particles/domain.hpp"
#include "particles/particles.hpp"

namespace riffle {

/// Share of the kernel's support that must be filled with water for a point to count as wet. It is 1 inside,
/// and 1/2 on the surface and on the bed.
inline constexpr double wet_share = 0.5;

/// The flow at one instant as instruments look at it. Keeps views of the particles, which must outlive it and
/// stay as they are.
class FluidView {
  public:
    /// `density`: rho0, kg/m3; `smoothing_length`: h, m.
    FluidView(const Particles<2>& particles, const Domain<2>& domain, KernelKind kernel, double density,
              double smoothing_length, SurfaceDetection detection);

    struct Velocity {
        double u, w;  ///< m/s
    };
    /// Velocity at a point: the kernel sum over the fluid particles, normalised with the sum of the kernel
    /// (Shepard) and corrected to first order, so that a field linear in x and z is reproduced up to
    /// rounding, beside the bed and the surface too. NaN where less than `wet_share` of the support is
    /// filled.
    [[nodiscard]] Velocity velocity_at(double x, double z) const;

    /// Elevation of the surface over each x, m above the bed level, found as `detection` says
    /// (sph/free_surface.hpp); NaN where there is no water.
    [[nodiscard]] std::vector<double> surface_at(std::span<const double> x) const;

    struct Section {
        double flow_rate;  ///< of water per unit width, m2/s
        double depth;      ///< area of water per length of channel, m
    };
    /// Flow through a section: the sums of V u and V over the particles, weighted along x with the
    /// one-dimensional kernel. Their means over all sections of a channel are those of its water.
    [[nodiscard]] Section section_at(double x) const;

  private:
    const Particles<2>& particles_;
    Domain<2> domain_;
    KernelKind kernel_;
    double h_;
    SurfaceDetection detection_;
    std::vector<double> volume_;  ///< area of each particle, m2
    ParticleCells cells_;
};

}  // namespace riffle
