#pragma once

#include "case/case.hpp"
#include "particles/particles.hpp"

namespace riffle::inline solver {

/// The perturbation of a case, m/s: what it gives, or a quarter of the friction velocity sqrt(g S0 h) of a
/// flow over spheres in two dimensions, all of it where the eddies are resolved, 0 of others. Without it the
/// particles of such a flow slide in the rows of the lattice for tens of seconds, before they break up into
/// the state that lasts.
[[nodiscard]] double start_perturbation(const Case& c);

/// Add a random velocity without divergence to the particles of a start: the curl of a vector potential of
/// random Fourier modes, from the depth (or the channel, where it is smaller) down to eight spacings or an
/// eighth of the depth, as many in each octave, which vanishes with its gradient at bed, surface and walls.
/// In two dimensions the potential has its component across the channel alone. Its root mean square over
/// the particles, of one component, is start_perturbation(), its mean zero; the same seed gives the same
/// field on every machine.
///
/// Where the eddies are resolved in a flow in space it carries the stress of the flow that is to come, for
/// water whose eddies must grow first runs away from its bed: two thirds of its energy are those of streaks
/// (StartStreaks), and each mode moves in the direction in which -u'w' is largest.
/// Its root mean square is then start_perturbation() to a tenth, for streaks and modes may lean alike.
template <int D>
void perturb_velocity(const Case& c, Particles<D>& particles);

}  // namespace riffle::inline solver
