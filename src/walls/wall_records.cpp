#include "walls/wall_records.hpp"

#include "boundary/wall.hpp"
#include "engine/pair_setup.hpp"
#include "sph/pair_terms.hpp"
#include "walls/wall_continuation.hpp"

namespace riffle::inline walls {

template <int D, class Real>
void pack_wall_records(const Case& c, const Scheme& scheme, const WallParticles<D>& walls,
                       const Clusters<D>& clusters, PairData<D, Real>& data) {
    constexpr auto axes = static_cast<std::size_t>(D);
    const WallAction action = wall_action(c);
    const Continuations<D> continuations(c, scheme, walls);
    const std::size_t slots = clusters.slots();
    data.wall_gradient.assign(slots + 1, {});
    data.wall_force.assign(slots + 1, {});
    for (std::size_t slot = 0; slot < slots; ++slot) {
        auto& gradient = data.wall_gradient[slot];
        auto& force = data.wall_force[slot];
        for (std::size_t k = 0; k < axes; ++k) {
            gradient.x[k] = clusters.slot_position[k][slot];
            force.x[k] = gradient.x[k];
        }
        const std::int32_t particle = clusters.particle_of(slot);
        if (particle < 0) continue;
        const auto i = static_cast<std::size_t>(particle);
        for (std::size_t k = 0; k < axes * axes; ++k) {
            // Dynamic particles are fluid that does not move: the whole velocity counts.
            const double identity = k % (axes + 1) == 0 ? 1.0 : 0.0;
            gradient.projector[k] = static_cast<Real>(action.dynamic ? identity : walls.projector[k][i]);
        }
        if (!action.dynamic) gradient.continuation = continuations.template of<Real>(i);
        force.continuation = gradient.continuation;
        gradient.volume = static_cast<Real>(walls.volume[i]);
        force.weight = gradient.volume;
        force.viscous_weight = action.rests_at(walls, i) ? gradient.volume : Real(0);
        force.viscosity_root = static_cast<Real>(viscosity_root(pair_viscosity(c, scheme)));
    }
    data.wall_gradient.back().x = data.wall_gradient.front().x;
    data.wall_force.back().x = data.wall_force.front().x;
}

template void pack_wall_records(const Case&, const Scheme&, const WallParticles<2>&, const Clusters<2>&,
                                PairData<2, float>&);
template void pack_wall_records(const Case&, const Scheme&, const WallParticles<2>&, const Clusters<2>&,
                                PairData<2, double>&);
template void pack_wall_records(const Case&, const Scheme&, const WallParticles<3>&, const Clusters<3>&,
                                PairData<3, float>&);
template void pack_wall_records(const Case&, const Scheme&, const WallParticles<3>&, const Clusters<3>&,
                                PairData<3, double>&);

}  // namespace riffle::inline walls
