#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "boundary/boundary_planes.hpp"
#include "boundary/solid_surface.hpp"
#include "boundary/wall_motion.hpp"
#include "engine/flow.hpp"

namespace riffle::inline components {

/// Where a solid stands on a plane wall, the particles of that wall behind its foot push the water before it
/// too: across the wall for the wall, along it for the solid, whose face ends there. Without them the force
/// on a gate lacks what the lowest quarter of a spacing carries.
template <int D, class Real>
class SolidCorners {
  public:
    using Flow = FlowOf<D, Real>;

    /// Pairs of the water with particles of walls behind a solid, and along which axes their push is its own.
    struct Part {
        NeighbourList list;
        std::array<bool, 3> along{};
    };

    explicit SolidCorners(const Case& c) : planes_(boundary_planes<D>(c)) {}

    /// The parts of a solid at rest, of the pairs that `with_solid` says the clusters of the water to have
    /// with it, when the lists are built.
    template <class WithSolid>
    [[nodiscard]] std::vector<Part> find(const Flow& flow, const SolidSurfaces& surfaces, std::size_t solid,
                                         const WithSolid& with_solid) const {
        const NeighbourList& all = flow.fluid_wall;
        // Axes across the walls that a particle stands behind, as bits, under the solid; 0: none.
        std::vector<std::uint8_t> across(flow.wall_clusters.slots(), unknown);
        std::vector<std::uint8_t> kinds;
        const auto for_walls = [&](const auto& f) {
            for (std::size_t cluster = 0; cluster < all.size(); ++cluster) {
                if (with_solid(cluster)) for_listed_slots(all, cluster, f);
            }
        };
        for_walls([&](std::size_t, std::size_t slot) {
            if (across[slot] == unknown) across[slot] = axes_across(flow, surfaces, solid, slot);
            const std::uint8_t kind = across[slot];
            const bool known = std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
            if (kind != 0 && !known) kinds.push_back(kind);
        });
        std::vector<Part> parts;
        for (const std::uint8_t kind : kinds) {
            Part part{all, {}};
            std::fill(part.list.masks.begin(), part.list.masks.end(), std::uint8_t{0});
            for_walls([&](std::size_t mask, std::size_t slot) {
                if (across[slot] != kind) return;
                part.list.masks[mask] = static_cast<std::uint8_t>(
                    part.list.masks[mask] | (all.masks[mask] & 1U << slot % cluster_size));
            });
            for (std::size_t axis = 0; axis < 3; ++axis) part.along[axis] = (kind & 1U << axis) == 0;
            parts.push_back(std::move(part));
        }
        return parts;
    }

  private:
    static constexpr std::uint8_t unknown = 255;

    [[nodiscard]] std::uint8_t axes_across(const Flow& flow, const SolidSurfaces& surfaces, std::size_t solid,
                                           std::size_t slot) const {
        if (flow.wall_clusters.particle_of(slot) < 0) return 0;
        const auto particle = static_cast<std::size_t>(flow.wall_clusters.particle_of(slot));
        if (!flow.walls.body.empty() && flow.walls.body[particle] != resting_body) return 0;
        Vec<D> place = vector_of(flow.walls.position, particle);
        std::uint8_t kind = 0;
        for (const BoundaryPlane& plane : planes_) {
            if (plane.distance<D>(place) > 0.0) continue;
            // Just before the wall.
            place[plane.axis] = plane.place + plane.inward * 0.25 * flow.c.numerics.spacing;
            // In two dimensions the second axis is z.
            const std::size_t axis = D == 2 && plane.axis == 1 ? 2 : plane.axis;
            kind = static_cast<std::uint8_t>(kind | 1U << axis);
        }
        return kind != 0 && surfaces.contains(solid, in_space_of<D>(place)) ? kind : std::uint8_t{0};
    }

    std::vector<BoundaryPlane> planes_;
};

}  // namespace riffle::inline components
