#pragma once

#include "case/case.hpp"
#include "particles/particles.hpp"

namespace riffle {

/// Add a random velocity without divergence to the particles of a start: the curl of a vector potential of
/// random Fourier modes, from the depth (or the channel, where it is smaller) down to eight spacings, as many
/// in each octave, which vanishes with its gradient at bed, surface and walls. In two dimensions the
/// potential has its component across the channel alone. Its root mean square over the particles, of one
/// component, is `start.perturbation`, its mean zero; the same seed gives the same field on every machine.
template <int D>
void perturb_velocity(const Case& c, Particles<D>& particles);

}  // namespace riffle
