#pragma once

#include <vector>

#include "boundary/boundary_planes.hpp"
#include "case/case.hpp"
#include "particles/domain.hpp"

namespace riffle::inline boundary {

/// Walls that push the water away (Monaghan & Kos 1999, as in SPHysics): each particle of a row on the wall
/// acts on the water along its normal,
///
///     a = n R(y) P(x) eps,   R = A (1 - q)/sqrt(q),  q = y/(2 dx) < 1,   P = [1 + cos(pi x/dx)]/2, |x| < dx,
///
/// y the distance from the wall, x along it to the particle, A = g H/h. Over an even row the P sum to 1 at
/// every x, so a plane wall is calculated as the plane that it acts like, without its particles. eps is the
/// depth below the still surface over H plus 0.02, at most 1, plus 20 |u_n|/c0, at most 1, of water that
/// approaches.
template <int D>
class RepulsiveWalls {
  public:
    RepulsiveWalls() = default;
    /// The walls of a case with `numerics.wall` = "repulsive": the bed, end walls and side walls; of another
    /// case none.
    RepulsiveWalls(const Case& c, double sound_speed);

    [[nodiscard]] bool active() const { return !planes_.empty(); }

    /// Acceleration of water at a place and velocity, m/s2. Water on the plane or behind it is pushed as at a
    /// hundredth of the reach.
    [[nodiscard]] Vec<D> acceleration(const Vec<D>& x, const Vec<D>& u) const;

  private:
    std::vector<BoundaryPlane> planes_;
    double reach_ = 0.0;     ///< 2 dx
    double strength_ = 0.0;  ///< A
    double depth_ = 0.0;     ///< H
    double sound_speed_ = 0.0;
};

}  // namespace riffle::inline boundary
