#pragma once

#include <functional>

#include "case/case.hpp"
#include "particles/domain.hpp"
#include "particles/particles.hpp"

namespace riffle::inline particles {

/// The lattice that a case starts from: rows along the bed, evenly spaced normal to it.
/// Square: spacing H/round(H/dx) between rows. Hexagonal: rows sqrt(3)/2 of the spacing along x apart, the
/// same area per particle, and every other row shifted by half a spacing. Body-centred (three dimensions):
/// square rows a = 2^(1/3) dx apart in x and y, half of that in z, every other one shifted by a/2 in x and y;
/// the same volume per particle.
struct Lattice {
    int columns = 0;  ///< particles along x
    int files = 1;    ///< particles along y; one in a plane
    int rows = 0;     ///< particles along z
    double dx = 0.0;  ///< spacing along x, m
    double dy = 0.0;  ///< spacing along y, m; 1 in a plane, whose masses are those of a metre's width
    double dz = 0.0;  ///< spacing along z, m
    StartLattice arrangement = StartLattice::square;

    /// Position of a particle; rows and columns beyond the fluid (negative ones too) are those of the walls.
    [[nodiscard]] double x(int column, int row) const {
        return (column + 0.5 + (arrangement == StartLattice::square ? 0.0 : shift(row))) * dx;
    }
    [[nodiscard]] double y(int file, int row) const {
        return (file + 0.5 + (arrangement == StartLattice::body_centred ? shift(row) : 0.0)) * dy;
    }
    [[nodiscard]] double z(int row) const { return (row + 0.5) * dz; }

    /// Volume of a particle, m3; in a plane of a metre's width.
    [[nodiscard]] double volume() const { return dx * dy * dz; }
    /// Places of the lattice in the water at its depth.
    [[nodiscard]] std::size_t places() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) *
               static_cast<std::size_t>(files);
    }

  private:
    static constexpr double shift(int row) { return row % 2 == 0 ? -0.25 : 0.25; }
};
[[nodiscard]] Lattice lattice_of(const Case& c);

/// Rows of the lattice below a surface that stands at another height than its own: as many as fit best, drawn
/// out or together to end at it.
struct RowsBelow {
    int rows = 0;
    double height = 0.0;  ///< of each, m
};
[[nodiscard]] RowsBelow rows_below(const Lattice& lattice, double surface);

/// Domain of a case: periodic axes as the case says, margins for the walls and for the moving surface.
template <int D = 2>
[[nodiscard]] Domain<D> domain_of(const Case& c);

/// Height of the water at the start above a place (x, z) in it, m: the surface at the total depth, or the
/// outline of the water.
[[nodiscard]] double still_surface(const Case& c, double x, double z);

/// Fluid particles at rest on the lattice (first row at dz/2), displaced at random by the start's jitter;
/// density deviation and mass are left at zero. In two dimensions those inside of the outline of the water,
/// where the start gives one, and not in or closer than a quarter of the spacing to a solid. In three
/// dimensions the same with a packed start, else those in a solid are the wall particles' places
/// (boundary/mesh_fill.hpp). `surface`: height of the water along the channel, m, to which the rows of each
/// column reach (rows_below); not given, the depth of the case. Behind an open end at x = L there is water as
/// well, as far as the kernels of the channel see.
template <int D = 2>
[[nodiscard]] Particles<D> lattice_particles(const Case& c,
                                             const std::function<double(double x)>& surface = {});

}  // namespace riffle::inline particles
