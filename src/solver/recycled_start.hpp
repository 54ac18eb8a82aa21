#pragma once

#include <string>

#include "case/case.hpp"
#include "engine/scheme.hpp"
#include "particles/particles.hpp"

namespace riffle::inline solver {

/// Whether the water of one case is made of that of another by interpolation: where spacing, length or width
/// differ. Else its particles go on as they are.
[[nodiscard]] bool is_recycled(const Case& c, const Case& other);

/// Why the flow of one case cannot be put into the channel of another by repeating it; empty where it can. A
/// channel with periodic or open ends takes several lengths of a periodic one, with periodic sides several
/// widths.
[[nodiscard]] std::string why_not_recycled(const Case& c, const Case& other);

/// The start of a case, its particles on their lattice and hydrostatic, with the velocity that another case's
/// water has at their places: the kernel's mean, exact for linear fields (FluidView::velocity_at), and above
/// its surface that below it. A shorter or narrower flow is repeated. What the coarser of the two spacings
/// does not hold is lost.
template <int D>
[[nodiscard]] Particles<D> recycled_particles(const Case& c, const Scheme& scheme, const Case& other,
                                              const Particles<D>& water);

/// Particles of another run of the same spacing and length, for a channel with open ends: those before the
/// inflow are left out, where the ends make their own, and water of a periodic channel goes on behind the
/// outflow.
template <int D>
void stand_between_open_ends(const Case& c, const Case& other, Particles<D>& water);

}  // namespace riffle::inline solver
