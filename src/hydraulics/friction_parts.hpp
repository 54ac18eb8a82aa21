#pragma once

#include <span>

namespace riffle::inline hydraulics {

/// Part of the friction factor f = 8 u_*^2/U^2 that a shear stress makes, by the exact decomposition of
/// uniform flow (Fukagata, Iwamoto & Kasagi 2002; over rough beds Nikora et al. 2019): where the stresses tau
/// on horizontal planes together carry the weight of the water above them, tau_c (1 - xi) with xi = (z -
/// z_c)/(z_s - z_c) from the crests z_c to the surface z_s, the mean of that identity with the weight 1 - xi
/// gives
///   f = 24/(rho U^2 (z_s - z_c)) sum of the integrals of (1 - xi) tau dz.
/// Stresses near the bed count most, those at the surface not at all.
///
/// `height`: rising, m; `stress`: at these heights, Pa, linear between them and to the crests, zero at the
/// surface; `velocity`: U, mean over the depth from the crests, m/s. Throws InputError unless the surface
/// lies above the crests, U and the density are greater than zero, and there are two heights and as many
/// stresses.
[[nodiscard]] double friction_factor_of_stress(std::span<const double> height, std::span<const double> stress,
                                               double crests, double surface, double density,
                                               double velocity);

}  // namespace riffle::inline hydraulics
