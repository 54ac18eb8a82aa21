#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "case/case.hpp"
#include "particles/domain.hpp"
#include "particles/particle_cells.hpp"
#include "particles/particles.hpp"
#include "particles/working_values.hpp"
#include "sph/free_surface.hpp"

namespace riffle::inline instruments {

/// Share of the kernel's support that must be filled with water for a point to count as wet. It is 1 inside,
/// and 1/2 on the surface and on the bed.
inline constexpr double wet_share = 0.5;

/// Share below which the pressure at a point fades out: that in the corner of three walls is 1/8.
inline constexpr double least_wet_share = 0.1;

/// The flow at one instant as instruments look at it, in two or three dimensions. Points are (x, y, z); in
/// two dimensions y is not looked at.
class FluidView {
  public:
    virtual ~FluidView() = default;

    struct Velocity {
        double u, v, w;  ///< m/s; v is 0 in two dimensions
    };
    /// Velocity at a point: the kernel sum over the fluid particles, normalised with the sum of the kernel
    /// (Shepard) and corrected to first order, so that a linear field is reproduced up to rounding, beside
    /// the bed, the sides and the surface too. NaN where less than `wet_share` of the support is filled; for
    /// this the water goes on behind end walls, side walls and a plane of symmetry as its mirror image.
    [[nodiscard]] virtual Velocity velocity_at(const Vec<3>& point) const = 0;

    struct Flow {
        Velocity velocity;
        double pressure;      ///< Pa
        double shear_stress;  ///< tau_xz, Pa
    };
    /// Velocity, pressure and shear stress at a point, the latter two interpolated in the same way from these
    /// values of the particles, Pa.
    [[nodiscard]] virtual Flow flow_at(const Vec<3>& point, const WorkingValues& pressure,
                                       std::span<const double> shear_stress) const = 0;
    struct Pressure {
        double pressure;   ///< Pa
        double wet_share;  ///< share of the kernel's support that is water
    };
    /// Pressure at a point from that of the particles, Pa: the mean with the kernel's weights, carried to the
    /// point's height with the weight of the water (Pa/m), as walls are given theirs (Adami et al. 2012).
    /// Where less than `least_wet_share` of the support is filled, as much smaller: to 0 where there is none.
    /// The mean reckons with the mirror images behind plane walls, the share with the water alone.
    [[nodiscard]] virtual Pressure pressure_at(const Vec<3>& point, const WorkingValues& pressure,
                                               double weight) const = 0;

    /// Pressure at a place of the surface of a solid, Pa: that of the linear field that fits the water around
    /// it best, for a solid may have any shape and pressure any slope there. Where less than a quarter of the
    /// support is water that says nothing, and it is pressure_at().
    [[nodiscard]] virtual Pressure pressure_on_solid(const Vec<3>& place, const WorkingValues& pressure,
                                                     double weight) const = 0;

    /// Elevation of the surface over each place (x, y), m above the bed level, found as the case says
    /// (sph/free_surface.hpp), with the mirror images; NaN where there is no water.
    [[nodiscard]] virtual std::vector<double> surface_at(std::span<const Vec<2>> at) const = 0;

    struct Section {
        double flow_rate;  ///< of water: per unit width, m2/s; in three dimensions of the whole width, m3/s
        double depth;      ///< area of water per length of channel; volume per plan area, m
        double momentum_flux;   ///< along the channel: per unit width, N/m; of the whole width, N
        double pressure_force;  ///< on the section, so; 0 where no pressures are given
        /// Of motion, height over the bed level and pressure: per unit width, W/m; of the whole width, W.
        /// Without the work of the pressure where no pressures are given.
        double energy_flux;
    };
    /// Flow through a section: the sums of V u, V, m u^2 and V p over the particles, weighted along x with
    /// the one-dimensional kernel. The means of the first two over all sections of a channel are those of its
    /// water; the difference of the last two together between two sections is what the forces on the water
    /// between them take. `pressure`: by particle, Pa, or null.
    [[nodiscard]] virtual Section section_at(double x, const WorkingValues* pressure) const = 0;
    [[nodiscard]] Section section_at(double x) const { return section_at(x, nullptr); }
};

/// The velocity of the water at a place: near and above its surface, where a point is not wet, that of the
/// wet point below it, at most two smoothing lengths (m) down; nothing where there is none.
[[nodiscard]] std::optional<FluidView::Velocity> velocity_below(const FluidView& view, Vec<3> place,
                                                                double smoothing_length);

/// The view of the particles of a simulation in D dimensions. Keeps views of the particles, which must
/// outlive it and stay as they are.
template <int D>
class FluidViewIn final : public FluidView {
  public:
    /// `h`: smoothing length, m. `walls`: whose bed and solids the surface reckons with; null where they are
    /// not known, and levels within two smoothing lengths of them are low.
    FluidViewIn(const Case& c, const Particles<D>& particles, double h,
                const WallParticles<D>* walls = nullptr);

    [[nodiscard]] Velocity velocity_at(const Vec<3>& point) const override;
    [[nodiscard]] Flow flow_at(const Vec<3>& point, const WorkingValues& pressure,
                               std::span<const double> shear_stress) const override;
    [[nodiscard]] Pressure pressure_at(const Vec<3>& point, const WorkingValues& pressure,
                                       double weight) const override;
    [[nodiscard]] Pressure pressure_on_solid(const Vec<3>& place, const WorkingValues& pressure,
                                             double weight) const override;
    [[nodiscard]] std::vector<double> surface_at(std::span<const Vec<2>> at) const override;
    using FluidView::section_at;
    [[nodiscard]] Section section_at(double x, const WorkingValues* pressure) const override;

  private:
    /// The particles with their mirror images behind ends and sides that are not periodic.
    struct Mirrored {
        std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
        std::vector<std::size_t> of;  ///< particle of each image
    };
    using Positions = typename ParticleCells<D>::Positions;
    [[nodiscard]] SolidParticles<D> solids() const;
    [[nodiscard]] static Mirrored mirror(const Case& c, const Particles<D>& particles, double reach);
    [[nodiscard]] Positions positions() const;
    /// Values at a point of the linear fields that fit those of the particles around it best; NaN where it is
    /// dry. `values_of(j)` gives those of particle j.
    template <std::size_t N, class Values>
    [[nodiscard]] std::array<double, N> interpolate(const Vec<3>& point, const Values& values_of) const;
    /// f(number, weight, distance in smoothing lengths) for the particles and images around a point, with the
    /// weights V W of the kernel.
    template <class F>
    void weigh_around(const Vec<3>& point, const F& f) const;

    const Particles<D>& particles_;
    const WallParticles<D>* walls_;
    Domain<D> domain_;
    KernelKind kernel_;
    double h_;
    double width_;    ///< of a section: 1 in two dimensions
    double gravity_;  ///< across the bed, m/s2
    SurfaceDetection detection_;
    double surface_threshold_;
    Mirrored mirrored_;
    std::vector<double> volume_;    ///< of each particle, m2 or m3; then of each image
    std::vector<double> porosity_;  ///< at each particle; empty without porous zones
    ParticleCells<D> cells_;
};

extern template class FluidViewIn<2>;
extern template class FluidViewIn<3>;

}  // namespace riffle::inline instruments
