#pragma once

#include <vector>

#include "case/case.hpp"
#include "particles/particles.hpp"

namespace riffle::inline solver {

/// Give the particles of a periodic box the velocity of isotropic turbulence with the spectrum of
/// `start.file`, and add to `pressure` (over the density, m2/s2, one of each particle) that which keeps it
/// free of divergence. Each Fourier mode of the box has the energy of its wave number, and a direction and
/// phase at random (Rogallo 1981) that follow from the seed and the mode alone: a finer spacing has the same
/// eddies, and smaller ones beside them. Modes reach to half of a wave per spacing.
void start_isotropic(const Case& c, Particles<3>& particles, std::vector<double>& pressure);

}  // namespace riffle::inline solver
