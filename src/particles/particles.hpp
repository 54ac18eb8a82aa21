#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "particles/domain.hpp"
#include "particles/lost_particle.hpp"

namespace riffle {

/// What a method of time stepping keeps of the step before, by particle: values or rates of change (SI).
/// Empty before the first step and with methods that keep nothing.
template <int D>
struct PreviousStep {
    std::array<std::vector<double>, static_cast<std::size_t>(D)> motion;  ///< velocity or acceleration
    std::vector<double> density;  ///< density deviation or its rate of change

    [[nodiscard]] bool empty() const { return density.empty(); }

    void resize(std::size_t n) {
        for (auto& component : motion) {
            component.resize(n);
        }
        density.resize(n);
    }
};

/// Master state of the fluid particles, in double precision, one array per quantity. SI.
template <int D>
struct Particles {
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> velocity;
    std::vector<double> density_deviation;  ///< s = rho/rho0 - 1: no rounding against rho0
    std::vector<double> mass;
    std::vector<std::int32_t> id;  ///< number at creation, kept through sorting
    PreviousStep<D> previous;
    std::vector<LostParticle> lost;  ///< the ledger of those that have left the domain, in order of time
    /// Position at the last build of the neighbour lists. Part of a saved state, so that a resumed run has
    /// the same lists in the same order, and the same bits, as an uninterrupted one; empty otherwise.
    std::array<std::vector<double>, static_cast<std::size_t>(D)> listed_position;

    [[nodiscard]] std::size_t size() const { return id.size(); }

    void resize(std::size_t n) {
        for (std::size_t k = 0; k < D; ++k) {
            position[k].resize(n);
            velocity[k].resize(n);
        }
        density_deviation.resize(n);
        mass.resize(n);
        id.resize(n);
    }

    /// Reorder all arrays but the listed positions: particle i becomes the old particle order[i]. An order of
    /// fewer particles drops the others.
    void permute(const std::vector<std::int32_t>& order);
};

/// A vector of one particle as (x, y, z); y of a plane is 0.
template <int D>
std::array<double, 3> in_space(const std::array<std::vector<double>, static_cast<std::size_t>(D)>& components,
                               std::size_t particle) {
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < D; ++k) {
        v[k == D - 1 ? 2 : k] = components[k][particle];
    }
    return v;
}

/// Particles of walls and solids.
template <int D>
struct WallParticles {
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    std::vector<double> volume;
    /// Symmetric matrix P per particle (row-major, D x D): the part of the fluid's velocity relative to the
    /// wall that counts in the continuity equation; n n^T on a flat wall, in a corner
    /// the identity, in an edge along the channel diag(0, 1, 1).
    std::array<std::vector<double>, static_cast<std::size_t>(D* D)> projector;
    std::array<std::vector<double>, static_cast<std::size_t>(D)>
        normal;                 ///< into the fluid; zero in a corner
    std::vector<double> depth;  ///< distance behind the wall's surface, m
    /// Which body a particle belongs to (boundary/wall_motion.hpp); empty where all are walls at rest.
    std::vector<std::int32_t> body;

    [[nodiscard]] std::size_t size() const { return volume.size(); }

    /// Reorder all arrays: particle i becomes the old particle order[i].
    void permute(const std::vector<std::int32_t>& order);
};

}  // namespace riffle
