#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "particles/domain.hpp"
#include "particles/field.hpp"
#include "particles/lost_particle.hpp"

namespace riffle::inline particles {

/// Master state of the fluid particles, in double precision, one array per quantity. SI.
template <int D>
struct Particles {
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> velocity;
    std::vector<double> density_deviation;  ///< s = rho/rho0 - 1: no rounding against rho0
    std::vector<double> mass;
    std::vector<std::int32_t> id;  ///< number at creation, kept through sorting
    std::vector<FurtherField> further;
    std::vector<LostParticle> lost;  ///< the ledger of those that have left the domain, in order of time
    /// Number of particles ever made: the next one has this id.
    std::int32_t created = 0;
    /// Position at the last build of the neighbour lists. Part of a saved state, so that a resumed run has
    /// the same lists in the same order, and the same bits, as an uninterrupted one; empty otherwise.
    std::array<std::vector<double>, static_cast<std::size_t>(D)> listed_position;

    [[nodiscard]] std::size_t size() const { return id.size(); }

    /// The one table of the fields: f(FieldInfo, values) for each array by particle but the listed positions.
    /// Sorting, adding, removing, saving, restoring and counting of bytes follow from it.
    template <class Self, class F>
    static void for_each_field(Self& self, const F& f) {
        for (std::size_t k = 0; k < D; ++k) {
            const std::string axis = axis_names<D>[k];
            f(FieldInfo{"position_" + axis, "m", "position " + axis}, self.position[k]);
            f(FieldInfo{"velocity_" + axis, "m/s", "velocity along " + axis}, self.velocity[k]);
        }
        f(FieldInfo{"density_deviation", "1", "rho/rho0 - 1"}, self.density_deviation);
        f(FieldInfo{"mass", D == 2 ? "kg/m" : "kg", D == 2 ? "mass per unit width" : "mass"}, self.mass);
        f(FieldInfo{"id", "1", "particle number"}, self.id);
        for (auto& field : self.further) f(field.info, field.values);
    }
    template <class F>
    void for_each_field(const F& f) {
        for_each_field(*this, f);
    }
    template <class F>
    void for_each_field(const F& f) const {
        for_each_field(*this, f);
    }

    /// Add a field without values; its place in `further`.
    std::size_t add_field(FieldInfo info);
    /// Take n particles; new ones are zero, with an id of 0. Further fields that have no values keep none.
    void resize(std::size_t n);
    /// Add n particles with ids of their own, all else zero; the index of the first one.
    std::size_t append(std::size_t n);
    /// Reorder all arrays but the listed positions: particle i becomes the old particle order[i]. An order of
    /// fewer particles drops the others.
    void permute(const std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const;
};

/// A vector of one particle.
template <class Components>
auto vector_of(const Components& components, std::size_t particle) {
    Vec<static_cast<int>(std::tuple_size_v<Components>)> v{};
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = components[k][particle];
    return v;
}

/// A vector of one particle as (x, y, z); y of a plane is 0.
template <int D>
std::array<double, 3> in_space(const std::array<std::vector<double>, static_cast<std::size_t>(D)>& components,
                               std::size_t particle) {
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < D; ++k) v[k == D - 1 ? 2 : k] = components[k][particle];
    return v;
}

/// The component of one particle across the channel; 0 in a plane.
template <int D>
double across_of(const std::array<std::vector<double>, static_cast<std::size_t>(D)>& components,
                 std::size_t particle) {
    return in_space<D>(components, particle)[1];
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
    std::vector<double> density_deviation;  ///< state; empty until the walls are part of a flow

    [[nodiscard]] std::size_t size() const { return volume.size(); }

    /// The one table of the arrays: f(values) for each.
    template <class Self, class F>
    static void for_each_array(Self& self, const F& f) {
        for (auto* const components : {&self.position, &self.normal}) {
            for (auto& values : *components) f(values);
        }
        for (auto& values : self.projector) f(values);
        f(self.volume);
        f(self.depth);
        f(self.body);
        f(self.density_deviation);
    }

    /// Reorder all arrays: particle i becomes the old particle order[i].
    void permute(const std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const;
};

}  // namespace riffle::inline particles
