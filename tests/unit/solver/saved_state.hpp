#pragma once

#include "solver/simulation.hpp"

namespace riffle::test {

/// The particles as a checkpoint holds them.
template <int D>
Particles<D> saved_particles(const SimulationIn<D>& simulation) {
    Particles<D> saved = simulation.particles();
    for (std::size_t k = 0; k < D && !simulation.lists_out_of_date(); ++k) {
        saved.listed_position[k].resize(saved.size());
        simulation.listed_positions(k, 0, saved.listed_position[k]);
    }
    return saved;
}

}  // namespace riffle::test
