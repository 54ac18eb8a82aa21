#pragma once

#include "case/case.hpp"
#include "particles/domain.hpp"
#include "particles/particles.hpp"

namespace riffle {

/// The square lattice that a case starts from: rows along the bed, spacing H/round(H/dx) normal to it.
struct Lattice {
    int columns = 0;  ///< particles along x
    int rows = 0;     ///< particles along z
    double dx = 0.0;  ///< spacing along x, m
    double dz = 0.0;  ///< spacing along z, m
};
[[nodiscard]] Lattice lattice_of(const Case& c);

/// Domain of a 2D case: periodic axes as the case says, margins for the walls and for the moving surface.
[[nodiscard]] Domain<2> domain_of(const Case& c);

/// Fluid particles at rest on the lattice (first row at dz/2), displaced at random by the start's jitter;
/// volumes are dx dz, density deviation and mass are left at zero.
[[nodiscard]] Particles<2> lattice_particles(const Case& c);

}  // namespace riffle
