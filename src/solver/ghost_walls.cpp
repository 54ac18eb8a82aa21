// Wall particles that carry the density found at their mirror images in the water (English et al. 2022).

#include "solver/pair_setup.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

template <int D, class Real>
void SimulationOf<D, Real>::update_walls_by_ghosts(std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin * cluster_size; slot < end * cluster_size; ++slot) {
        const std::int32_t particle = wall_clusters_.particle_of(slot);
        if (particle < 0) {
            continue;
        }
        const auto i = static_cast<std::size_t>(particle);
        const GhostValue<D>& ghost = ghosts_->of(i);
        // Without water near its image a particle is as dry as one a spacing above the surface.
        const double dry = -scheme_.normal_gravity * case_.numerics.spacing;
        wall_deviation_[i] = ghost.found ? ghost.deviation : scheme_.state.deviation(dry);
        wet_wall(slot, i, scheme_.state.pressure(wall_deviation_[i]));
        auto& record = data_.wall_force[slot];
        record.pressure = ghost.found ? static_cast<Real>(pair_pressure(wall_deviation_[i])) : Real(0);
        record.u = {};
        if (wall_law_.no_slip) {
            // The wall stands halfway between the particle and its image; a lid may move along the channel.
            const double lid = walls_.normal[vertical][i] < 0.0 ? case_.channel.lid_velocity : 0.0;
            for (std::size_t k = 0; k < axes; ++k) {
                record.u[k] = static_cast<Real>((k == 0 ? 2.0 * lid : 0.0) - ghost.velocity[k]);
            }
        }
    }
}

template void SimulationOf<2, float>::update_walls_by_ghosts(std::size_t, std::size_t);
template void SimulationOf<2, double>::update_walls_by_ghosts(std::size_t, std::size_t);
template void SimulationOf<3, float>::update_walls_by_ghosts(std::size_t, std::size_t);
template void SimulationOf<3, double>::update_walls_by_ghosts(std::size_t, std::size_t);

}  // namespace riffle
