#pragma once

#include "case/case.hpp"
#include "engine/scheme.hpp"
#include "particles/clusters.hpp"
#include "particles/particles.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::inline walls {

/// Records of the walls: position, projector and volume, one record more than slots.
template <int D, class Real>
void pack_wall_records(const Case& c, const Scheme& scheme, const WallParticles<D>& walls,
                       const Clusters<D>& clusters, PairData<D, Real>& data);

}  // namespace riffle::inline walls
