#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "boundary/boundary_planes.hpp"
#include "boundary/wall.hpp"
#include "case/cross_section.hpp"
#include "case/flow_kind.hpp"
#include "engine/scheme.hpp"
#include "particles/lattice.hpp"
#include "sph/correction.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::inline walls {

/// How far each wall continues the water, 0 to 1. Water and end or side wall meet the surface at the same
/// height: the wall is corrected like the water, so that nothing varies along the surface at rest. Under a
/// bed, and along what stands along the channel (a side wall, the banks of a section), this would be a force
/// along it: friction of 2 to 4 % of the weight by side walls, a thrust of up to a third of it by banks. But
/// water in the corner of bed and wall has a quarter of its neighbours left: corrected through these alone, B
/// = (I - M_wall) M_fluid^-1 makes so much of their disorder that water runs down the wall and out along the
/// bed. So the bed continues the water too where a particle can see both, 2h from the wall, and less and less
/// up to 6h: a sudden end drives a current as well. Solids have faces of all directions and corners: they
/// continue the water throughout, and the bed beside them.
template <int D>
class Continuations {
  public:
    Continuations(const Case& c, const Scheme& scheme, const WallParticles<D>& walls)
        : planes_(boundary_planes<D>(c)),
          h_(scheme.smoothing_length),
          walls_(walls),
          domain_(domain_of<D>(c)),
          edge_(bed_ends(c) ? c.channel.length : std::numeric_limits<double>::infinity()),
          walls_run_along_(D == 3 && c.channel.ends != Ends::walls) {
        for (const Solid& solid : c.solids) {
            has_faces_across_.push_back(!walls_run_along_ || !is_section(solid.shape));
        }
        for (std::size_t i = 0; i < walls.body.size(); ++i) {
            if (is_solid(walls, i)) {
                solids_.push_back(i);
                if (has_faces_across(i)) solids_across_.push_back(i);
            }
        }
    }

    /// Of wall particle i, by rows of B.
    template <class Real>
    [[nodiscard]] Continuation<D, Real> of(std::size_t i) const {
        Continuation<D, Real> result{};
        if (is_bed(i)) {
            // The search among the particles of solids is made once where all of them are alike.
            const double solids = beside_solids(i, solids_);
            const bool alike = solids_across_.size() == solids_.size();
            const double solids_across = alike ? solids : beside_solids(i, solids_across_);
            const double walls = beside_walls(i);
            const double edge = faded(edge_ - walls_.position[0][i]);
            result.back() = static_cast<Real>(std::max({walls, edge, solids}));
            result.front() =
                static_cast<Real>(std::max({walls_run_along_ ? 0.0 : walls, edge, solids_across}));
        } else {
            result.back() = Real(1);
            const bool along = is_solid(walls_, i) ? has_faces_across(i) : !walls_run_along_;
            result.front() = along ? Real(1) : Real(0);
        }
        return result;
    }

  private:
    [[nodiscard]] bool has_faces_across(std::size_t i) const {
        return has_faces_across_[static_cast<std::size_t>(walls_.body[i] - first_solid)];
    }

    [[nodiscard]] bool is_bed(std::size_t i) const {
        return !is_solid(walls_, i) && walls_.normal[D - 1][i] != 0.0;
    }

    [[nodiscard]] double faded(double distance) const {
        return 1.0 - smoothstep<double>(2.0, 6.0, distance / h_);
    }

    [[nodiscard]] double beside_walls(std::size_t i) const {
        double continued = 0.0;
        for (const BoundaryPlane& plane : planes_) {
            if (plane.axis + 1 < static_cast<std::size_t>(D)) {
                continued = std::max(continued, faded(plane.distance<D>(vector_of(walls_.position, i))));
            }
        }
        return continued;
    }

    [[nodiscard]] double beside_solids(std::size_t i, const std::vector<std::size_t>& solids) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (const std::size_t j : solids) {
            double squared = 0.0;
            for (std::size_t k = 0; k < D; ++k) {
                const double extent = domain_.periodic[k] ? domain_.extent(static_cast<int>(k)) : 0.0;
                const double apart = std::abs(walls_.position[k][j] - walls_.position[k][i]);
                const double short_way = extent > 0.0 ? std::min(apart, extent - apart) : apart;
                squared += short_way * short_way;
            }
            nearest = std::min(nearest, squared);
        }
        return solids.empty() ? 0.0 : faded(std::sqrt(nearest));
    }

    std::vector<BoundaryPlane> planes_;
    double h_;
    const WallParticles<D>& walls_;
    Domain<D> domain_;
    double edge_;                             ///< where the bed ends, m
    bool walls_run_along_;                    ///< all walls but solids, where none closes the channel
    std::vector<bool> has_faces_across_;      ///< by solid
    std::vector<std::size_t> solids_;         ///< particles of solids
    std::vector<std::size_t> solids_across_;  ///< of those with faces across the channel
};

}  // namespace riffle::inline walls
