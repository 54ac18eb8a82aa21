#pragma once

#include "case/case.hpp"
#include "column/column.hpp"
#include "particles/particles.hpp"
#include "solver/scheme.hpp"

namespace riffle {

/// Whether the case has a steady shear flow that the column twin can solve.
[[nodiscard]] bool has_column(const Case& c);

/// Fluid particles at t = 0: lattice, mass from the hydrostatic density, velocity by the kind of start.
/// `column` is needed for the start "column", and for "uniform" without a velocity.
template <int D = 2>
[[nodiscard]] Particles<D> initial_particles(const Case& c, const Scheme& scheme, const ColumnResult* column);

}  // namespace riffle
