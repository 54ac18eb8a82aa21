#pragma once

#include <memory>
#include <vector>

#include "boundary/wall.hpp"
#include "engine/scheme.hpp"
#include "sph/pair_loops.hpp"
#include "sph/pair_sum.hpp"
#include "sph/particle_loops.hpp"

namespace riffle::inline engine {

// What the loops are given of a case: by the simulation, and by whoever runs the loops without one.

/// Whether the two-point viscosity weighs the pairs by their direction: the closure's mixing length is
/// another across the channel, and acts through the pairs.
[[nodiscard]] bool has_directional_viscosity(const Case& c);

/// Whether pressures and viscosity are weighed with the volumes of the neighbours, and the sums divided by
/// the density of a particle: in all forms but the symmetric one, which has masses over both densities.
[[nodiscard]] bool weighs_by_volume(const Case& c);

/// What the loops must be made for.
[[nodiscard]] LoopOptions loop_options(const Case& c);

/// Kinematic viscosity that the pairs act by, m2/s: that of the water, or with the artificial viscosity alpha
/// h c0/2.
[[nodiscard]] double pair_viscosity(const Case& c, const Scheme& scheme);

/// What a wall particle of a density deviation brings to the pressure sum of its pairs, m2/s2: p/rho0; in the
/// symmetric form (thesis 2.42), to which it is a particle like any other, p_w rho0/rho_w^2, as water at its
/// place would.
[[nodiscard]] double pair_pressure(const Case& c, const Scheme& scheme, double deviation);

/// Reach of the neighbour lists, m.
template <int D>
[[nodiscard]] double list_reach(const Case& c, const Scheme& scheme);

/// Constants of the pair sums.
template <int D, class Real>
[[nodiscard]] PairConstants<D, Real> pair_constants(const Case& c, const Scheme& scheme,
                                                    const FixedPoint<D>& fixed_point);

/// The sums beside the pair loops that the options of a case ask for: the one place where they are
/// registered.
template <int D, class Real>
[[nodiscard]] std::vector<std::unique_ptr<PairSum<D, Real>>> make_pair_sums(const Case& c,
                                                                            const Scheme& scheme,
                                                                            const FixedPoint<D>& fixed_point);

/// The reference pressure of a case; one that does not act where it asks for none.
[[nodiscard]] HydrostaticReference hydrostatic_reference(const Case& c, const Scheme& scheme);

/// Constants of the particle loops; the arrays and clusters are left for the caller.
template <int D>
[[nodiscard]] ParticleData<D> particle_constants(const Case& c, const Scheme& scheme,
                                                 const Domain<D>& domain);

}  // namespace riffle::inline engine
