#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "boundary/boundary_planes.hpp"
#include "boundary/solid_surface.hpp"
#include "boundary/wall_motion.hpp"
#include "engine/flow.hpp"

namespace riffle::inline components {

/// Where a solid stands on a plane wall, the particles of that wall push the water beside it too. Along the
/// wall those behind its foot push for the solid, whose face ends there: without them the force on a gate
/// lacks what the lowest quarter of a spacing carries. Across the wall they push water before the foot for
/// the wall, but water that stands over the foot, as over the thin toe of a slope, through the solid. What
/// the wall beside the foot does along itself to that water is halved (docs/theory.md 9).
template <int D, class Real>
class SolidCorners {
  public:
    using Flow = FlowOf<D, Real>;

    /// What of a force belongs to a solid: of its parts along the axes from none to all, and its friction.
    struct Share {
        Vec<3> along{};
        bool rubs = false;

        [[nodiscard]] bool any() const {
            return along[0] != 0.0 || along[1] != 0.0 || along[2] != 0.0 || rubs;
        }
    };

    /// What stands just before a particle of a wall.
    enum class Before { water, solid, other_solid };

    /// Where particles of walls stand.
    struct Kind {
        /// The planes that they stand behind, as bits; none where they matter to no particle of the water.
        std::uint8_t planes = 0;
        Before before = Before::water;

        bool operator==(const Kind&) const = default;
    };

    /// Pairs of the water with the particles of walls of one kind.
    struct Part {
        NeighbourList list;
        Kind kind;
    };

    explicit SolidCorners(const Case& c) : planes_(boundary_planes<D>(c)) {}

    /// Find the parts of a solid at rest, of the clusters of the water that `with_solid` says to have pairs
    /// with it, when the lists are built.
    template <class WithSolid>
    void find(const Flow& flow, const SolidSurfaces& surfaces, std::size_t solid,
              const WithSolid& with_solid) {
        find_water_over_foot(flow, surfaces, solid, with_solid);
        const NeighbourList& all = flow.fluid_wall;
        std::vector<std::optional<Kind>> kinds(flow.wall_clusters.slots());
        parts_.clear();
        const auto for_walls = [&](const auto& f) {
            for (std::size_t cluster = 0; cluster < all.size(); ++cluster) {
                if (with_solid(cluster)) for_listed_slots(all, cluster, f);
            }
        };
        for_walls([&](std::size_t, std::size_t slot) {
            if (kinds[slot]) return;
            const Kind kind = kind_of(flow, surfaces, solid, slot);
            kinds[slot] = kind;
            const bool known = std::any_of(parts_.begin(), parts_.end(),
                                           [&](const Part& part) { return part.kind == kind; });
            if (kind.planes != 0 && !known) parts_.push_back({all, kind});
        });
        for (Part& part : parts_) {
            std::fill(part.list.masks.begin(), part.list.masks.end(), std::uint8_t{0});
            for_walls([&](std::size_t mask, std::size_t slot) {
                if (kinds[slot] != part.kind) return;
                part.list.masks[mask] = static_cast<std::uint8_t>(
                    part.list.masks[mask] | (all.masks[mask] & 1U << slot % cluster_size));
            });
        }
    }

    [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

    /// What a part does to the particle in a slot that belongs to the solid.
    [[nodiscard]] Share share(const Part& part, std::size_t slot) const {
        const auto [planes, before] = part.kind;
        const unsigned through = planes & over_[slot];
        const double beside = before == Before::water && through != 0 ? from_beside : 0.0;
        const double along = before == Before::solid ? 1.0 : beside;
        Share share{.along = {along, along, along}, .rubs = through == planes};
        for (std::size_t plane = 0; plane < planes_.size(); ++plane) {
            if ((planes & 1U << plane) == 0) continue;
            share.along[axis_of(plane)] = (through & 1U << plane) != 0 ? 1.0 : 0.0;
        }
        return share;
    }

    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = over_.capacity();
        for (const Part& part : parts_) sum += part.list.bytes();
        return sum;
    }

  private:
    static constexpr std::array<double, 2> shares = {0.01, 0.25};
    static constexpr double from_beside = 0.5;

    /// In space: in two dimensions the second axis is z.
    [[nodiscard]] std::size_t axis_of(std::size_t plane) const {
        return D == 2 && planes_[plane].axis == 1 ? 2 : planes_[plane].axis;
    }

    /// Whether the solid stands on planes at a place: just before them, where a thin toe is, or a quarter of
    /// a spacing before them, where one is that the planes do not quite touch.
    [[nodiscard]] bool stands_on(const Flow& flow, const SolidSurfaces& surfaces, std::size_t solid,
                                 unsigned planes, const Vec<D>& place) const {
        return std::any_of(shares.begin(), shares.end(), [&](double share) {
            Vec<D> before = place;
            for (std::size_t k = 0; k < planes_.size(); ++k) {
                const BoundaryPlane& plane = planes_[k];
                if ((planes & 1U << k) == 0) continue;
                before[plane.axis] = plane.place + plane.inward * share * flow.c.numerics.spacing;
            }
            return surfaces.contains(solid, in_space_of<D>(before));
        });
    }

    /// For each particle of the water the planes on which the solid stands below it. By the listed positions,
    /// so that a resumed run finds the same.
    template <class WithSolid>
    void find_water_over_foot(const Flow& flow, const SolidSurfaces& surfaces, std::size_t solid,
                              const WithSolid& with_solid) {
        const Clusters<D>& clusters = flow.clusters;
        over_.assign(clusters.size() * cluster_size, 0);
        present_ = 0;
        for (std::size_t cluster = 0; cluster < clusters.size(); ++cluster) {
            if (!with_solid(cluster)) continue;
            for (std::size_t slot = cluster * cluster_size; slot < (cluster + 1) * cluster_size; ++slot) {
                Vec<D> place{};
                for (std::size_t k = 0; k < Flow::axes; ++k) {
                    place[k] = flow.fixed_point.decode(clusters.slot_position[k][slot], k);
                }
                for (std::size_t plane = 0; plane < planes_.size(); ++plane) {
                    if (!stands_on(flow, surfaces, solid, 1U << plane, place)) continue;
                    over_[slot] = static_cast<std::uint8_t>(over_[slot] | 1U << plane);
                }
                present_ = static_cast<std::uint8_t>(present_ | over_[slot]);
            }
        }
    }

    [[nodiscard]] Kind kind_of(const Flow& flow, const SolidSurfaces& surfaces, std::size_t solid,
                               std::size_t slot) const {
        if (flow.wall_clusters.particle_of(slot) < 0) return {};
        const auto particle = static_cast<std::size_t>(flow.wall_clusters.particle_of(slot));
        if (!flow.walls.body.empty() && flow.walls.body[particle] != resting_body) return {};
        const Vec<D> place = vector_of(flow.walls.position, particle);
        std::uint8_t behind = 0;
        for (std::size_t plane = 0; plane < planes_.size(); ++plane) {
            if (planes_[plane].template distance<D>(place) > 0.0) continue;
            behind = static_cast<std::uint8_t>(behind | 1U << plane);
        }
        if (behind == 0) return {};
        if (stands_on(flow, surfaces, solid, behind, place)) return {behind, Before::solid};
        if ((behind & present_) == 0) return {};
        // Where two solids meet toe to toe what is behind the other's foot pushes along the wall for that
        // one.
        for (std::size_t other = 0; other < flow.c.solids.size(); ++other) {
            if (other == solid || !flow.c.solids[other].rests()) continue;
            if (stands_on(flow, surfaces, other, behind, place)) return {behind, Before::other_solid};
        }
        return {behind, Before::water};
    }

    std::vector<BoundaryPlane> planes_;
    std::vector<Part> parts_;
    std::vector<std::uint8_t> over_;  ///< by slot of the water, planes as bits
    std::uint8_t present_ = 0;        ///< all of these together
};

}  // namespace riffle::inline components
