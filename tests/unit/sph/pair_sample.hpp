#pragma once

#include <array>
#include <vector>

#include "particles/domain.hpp"

namespace riffle {

/// A set of particles for the loops, disordered fluid over a few layers of wall, or fluid alone.
template <int D>
struct PairSample {
    static constexpr double spacing = 1.0 / 16.0;
    /// Width of the columns that clusters are cut from: 8 particles then fill a nearly cubic box.
    static constexpr double column_width = (D == 2 ? 2.67 : 2.0) * spacing;

    Domain<D> domain;
    FixedPoint<D> fixed_point;
    double h = 0.0;
    struct Particle {
        Vec<D> x{};
        Vec<D> u{};
        double s = 0.0;
        double volume = 0.0;
        double pressure = 0.0;
        double viscosity_root = 0.0;  ///< sqrt(mu/rho0)
        std::array<double, static_cast<std::size_t>(D* D)> stress{};
        std::array<double, static_cast<std::size_t>(D* D)> projector{};
        double continuation = 0.0;        ///< of a wall
        double continuation_along = 0.0;  ///< along the channel; in a plane the same
    };
    std::vector<Particle> fluid;
    std::vector<Particle> wall;

    /// r = a - b to the nearest image.
    [[nodiscard]] Vec<D> difference(const Vec<D>& a, const Vec<D>& b) const;
    [[nodiscard]] double volume() const;

    /// Whether all neighbours within the support stand on the same side of the periodic seams across the bed,
    /// where functions of x that are not periodic jump.
    [[nodiscard]] bool far_from_seams(const Particle& p) const;
};

/// The lattice (16 x 10 spacings of 1/16 in two dimensions, 8 x 8 x 8 in three, periodic across the bed) with
/// random displacements of up to `jitter` spacings, velocities, densities and tensors, on `layers` layers of
/// wall, half of which continue the fluid; periodic along z too without walls.
template <int D>
[[nodiscard]] PairSample<D> disordered_sample(double jitter, int layers, unsigned seed);

}  // namespace riffle
