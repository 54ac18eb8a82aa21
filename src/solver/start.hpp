#pragma once

#include <functional>

#include "case/case.hpp"
#include "column/column.hpp"
#include "engine/scheme.hpp"
#include "particles/particles.hpp"

namespace riffle::inline solver {

/// Streamwise velocity over the cross-section, m/s, at (y, z), m.
using SectionVelocity = std::function<double(double y, double z)>;

/// Fluid particles at t = 0: lattice, mass from the hydrostatic density, velocity by the kind of start.
/// `column` is needed for the start "column", and for "uniform" without a velocity; `section`, in three
/// dimensions, for "section". InputError where it is missing. Without `pack` they stay on the lattice where
/// the case asks for a packed start too.
template <int D = 2>
[[nodiscard]] Particles<D> initial_particles(const Case& c, const Scheme& scheme, const ColumnResult* column,
                                             const SectionVelocity& section = {}, bool pack = true);

}  // namespace riffle::inline solver
