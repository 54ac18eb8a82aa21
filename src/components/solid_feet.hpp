#pragma once

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"
#include "boundary/solid_surface.hpp"
#include "boundary/wall_motion.hpp"
#include "engine/flow.hpp"
#include "engine/pair_setup.hpp"

namespace riffle::inline components {

/// Where the forces of particles beside a solid act on its surface: for each the plane that touches the
/// surface at the place nearest to it when the lists were built. A force acts at its foot on that plane. On
/// the true surface, because the friction of a pair does not point along it: at half a spacing before the
/// surface its arm would be longer by as much.
template <int D, class Real>
class SolidFeet {
  public:
    using Flow = FlowOf<D, Real>;

    /// Of the particles in the clusters that `list`, of this solid alone, gives any wall particle. By the
    /// listed positions, so that a resumed run finds the same. `body`: the solid's state when they were.
    void find(const Flow& flow, const SolidSurfaces& surfaces, std::size_t solid, const BodyState& body,
              const NeighbourList& list) {
        const Clusters<D>& clusters = flow.clusters;
        first_.assign(clusters.size(), none);
        std::int32_t feet = 0;
        for (std::size_t cluster = 0; cluster < clusters.size(); ++cluster) {
            const auto begin = list.masks.begin() + static_cast<std::ptrdiff_t>(list.mask_begin[cluster]);
            const auto end = list.masks.begin() + static_cast<std::ptrdiff_t>(list.mask_begin[cluster + 1]);
            if (std::any_of(begin, end, [](std::uint8_t mask) { return mask != 0; })) {
                first_[cluster] = feet;
                feet += cluster_size;
            }
        }
        planes_.assign(static_cast<std::size_t>(feet), {});
        const double reach = list_reach<D>(flow.c, flow.scheme);
        parallel_blocks(clusters.size(), block_clusters, [&](std::size_t begin, std::size_t end) {
            for (std::size_t cluster = begin; cluster < end; ++cluster) {
                for (std::size_t lane = 0; first_[cluster] != none && lane < cluster_size; ++lane) {
                    const std::size_t slot = cluster * cluster_size + lane;
                    Vec<D> position{};
                    for (std::size_t k = 0; k < Flow::axes; ++k) {
                        position[k] = flow.fixed_point.decode(clusters.slot_position[k][slot], k);
                    }
                    const Vec<3> place = body.place_at_start(place_beside<D>(flow.domain, body, position));
                    const auto foot = surfaces.nearest(solid, place, reach);
                    planes_[static_cast<std::size_t>(first_[cluster]) + lane] =
                        foot ? Plane{foot->place, foot->normal} : Plane{place, {}};
                }
            }
        });
    }

    /// Whether any particle of a cluster has a pair with the solid.
    [[nodiscard]] bool has(std::size_t cluster) const { return first_[cluster] != none; }

    /// The foot of a particle, by the lane of its cluster, from a point of the solid, as at t = 0. `place`:
    /// of the particle, so.
    [[nodiscard]] Vec<3> arm(const SolidSurfaces& surfaces, std::size_t cluster, std::size_t lane,
                             const Vec<3>& place, const Vec<3>& point) const {
        const Plane& plane = planes_[static_cast<std::size_t>(first_[cluster]) + lane];
        const Vec<3> beside = surfaces.image_near(plane.place, place);
        double height = 0.0;
        for (std::size_t k = 0; k < 3; ++k) height += (beside[k] - plane.place[k]) * plane.normal[k];
        Vec<3> arm{};
        for (std::size_t k = 0; k < 3; ++k) arm[k] = beside[k] - height * plane.normal[k] - point[k];
        return arm;
    }

    [[nodiscard]] std::size_t bytes() const {
        return first_.capacity() * sizeof(first_[0]) + planes_.capacity() * sizeof(planes_[0]);
    }

  private:
    static constexpr std::int32_t none = -1;
    struct Plane {
        Vec<3> place{};
        Vec<3> normal{};  ///< zero: the force acts where the particle is
    };
    std::vector<std::int32_t> first_;  ///< of each cluster, its first lane in planes_
    std::vector<Plane> planes_;
};

}  // namespace riffle::inline components
