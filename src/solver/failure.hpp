#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "solver/run.hpp"
#include "solver/simulation.hpp"

namespace riffle::inline solver {

// What a run that fails leaves of the moment, for whoever looks for the cause.

/// A particle near the one at which the simulation failed.
struct NearbyParticle {
    std::size_t particle = 0;    ///< its index in the arrays
    double distance = 0.0;       ///< m
    std::size_t neighbours = 0;  ///< particles of the water within the kernel's support, without itself
};

/// The surroundings of a particle.
struct FailureScene {
    std::size_t particle = 0;             ///< its index in the arrays
    std::vector<NearbyParticle> nearest;  ///< by distance; the particle itself first
};

/// Particles that are looked at around the one that failed.
inline constexpr std::size_t failure_neighbours = 50;

/// The nearest particles to one whose own state need not be finite: its place is then that of the last build
/// of the neighbour lists.
template <int D>
[[nodiscard]] FailureScene look_around(const Case& c, const SimulationIn<D>& simulation,
                                       std::size_t particle);

/// Write failure.h5, all particles as the failed step left them and the table of the nearest, and its index
/// for ParaView. Throws FileError.
template <int D>
void write_failure(const RunFiles& files, const Case& c, const SimulationIn<D>& simulation,
                   const FailureScene& scene, const std::string& message);

/// The nearest particles as a table of text, the first ones of them.
template <int D>
[[nodiscard]] std::string neighbourhood_table(const SimulationIn<D>& simulation, const FailureScene& scene);

/// What the state around the particle points to, and what to do, in a few sentences.
template <int D>
[[nodiscard]] std::string advice(const SimulationIn<D>& simulation, const FailureScene& scene);

}  // namespace riffle::inline solver
