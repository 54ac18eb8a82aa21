#include "walls/wall_records.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "boundary/boundary_planes.hpp"
#include "boundary/wall.hpp"
#include "case/flow_kind.hpp"
#include "engine/pair_setup.hpp"
#include "particles/lattice.hpp"
#include "sph/correction.hpp"
#include "sph/pair_terms.hpp"

namespace riffle {

namespace {

// How far a wall continues the water, 0 to 1. Water and end or side wall meet the surface at the same height:
// the wall is corrected like the water, so that nothing varies along the surface at rest. Under a bed, and
// along a side wall (first_continued_row), this would be friction (2 to 4 %). But water in the corner of bed
// and wall has a quarter of its neighbours left: corrected through these alone, B = (I - M_wall) M_fluid^-1
// makes so much of their disorder that water runs down the wall and out along the bed. So the bed continues
// the water too where a particle can see both, 2h from the wall, and less and less up to 6h: a sudden end
// drives a current as well. Solids have faces of all directions and corners: they continue the water
// throughout, and the bed beside them.
template <int D>
class Continuation {
  public:
    Continuation(const Case& c, const Scheme& scheme, const WallParticles<D>& walls)
        : planes_(boundary_planes<D>(c)),
          h_(scheme.smoothing_length),
          walls_(walls),
          domain_(domain_of<D>(c)),
          edge_(bed_ends(c) ? c.channel.length : std::numeric_limits<double>::infinity()) {
        for (std::size_t i = 0; i < walls.body.size(); ++i) {
            if (is_solid(walls, i)) {
                solids_.push_back(i);
            }
        }
    }

    [[nodiscard]] double operator()(std::size_t i) const {
        if (is_solid(walls_, i) || walls_.normal[D - 1][i] == 0.0) {
            return 1.0;
        }
        return std::max(beside_walls(i), beside_solids(i));
    }

  private:
    [[nodiscard]] double faded(double distance) const {
        return 1.0 - smoothstep<double>(2.0, 6.0, distance / h_);
    }

    [[nodiscard]] double beside_walls(std::size_t i) const {
        double continued = faded(edge_ - walls_.position[0][i]);
        for (const BoundaryPlane& plane : planes_) {
            if (plane.axis + 1 < static_cast<std::size_t>(D)) {
                continued = std::max(continued, faded(plane.distance<D>(vector_of(walls_.position, i))));
            }
        }
        return continued;
    }

    [[nodiscard]] double beside_solids(std::size_t i) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (const std::size_t j : solids_) {
            double squared = 0.0;
            for (std::size_t k = 0; k < D; ++k) {
                const double extent = domain_.periodic[k] ? domain_.extent(static_cast<int>(k)) : 0.0;
                const double apart = std::abs(walls_.position[k][j] - walls_.position[k][i]);
                const double short_way = extent > 0.0 ? std::min(apart, extent - apart) : apart;
                squared += short_way * short_way;
            }
            nearest = std::min(nearest, squared);
        }
        return solids_.empty() ? 0.0 : faded(std::sqrt(nearest));
    }

    std::vector<BoundaryPlane> planes_;
    double h_;
    const WallParticles<D>& walls_;
    Domain<D> domain_;
    double edge_;  ///< where the bed ends, m
    std::vector<std::size_t> solids_;
};

}  // namespace

template <int D, class Real>
void pack_wall_records(const Case& c, const Scheme& scheme, const WallParticles<D>& walls,
                       const Clusters<D>& clusters, PairData<D, Real>& data) {
    constexpr auto axes = static_cast<std::size_t>(D);
    const WallAction action = wall_action(c);
    const Continuation<D> continuation(c, scheme, walls);
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
        if (particle < 0) {
            continue;
        }
        const auto i = static_cast<std::size_t>(particle);
        for (std::size_t k = 0; k < axes * axes; ++k) {
            // Dynamic particles are fluid that does not move: the whole velocity counts.
            const double identity = k % (axes + 1) == 0 ? 1.0 : 0.0;
            gradient.projector[k] = static_cast<Real>(action.dynamic ? identity : walls.projector[k][i]);
        }
        gradient.continuation = static_cast<Real>(action.dynamic ? 0.0 : continuation(i));
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

}  // namespace riffle
