#include "boundary/repulsive_wall.hpp"

#include <algorithm>
#include <cmath>

namespace riffle::inline boundary {

template <int D>
RepulsiveWalls<D>::RepulsiveWalls(const Case& c, double sound_speed) {
    if (c.numerics.wall != WallKind::repulsive) return;
    const Numerics& n = c.numerics;
    reach_ = 2.0 * n.spacing;
    depth_ = c.total_depth();
    strength_ = c.normal_gravity() * depth_ / (n.smoothing_ratio * n.spacing);
    sound_speed_ = sound_speed;
    planes_ = boundary_planes<D>(c);
}

template <int D>
Vec<D> RepulsiveWalls<D>::acceleration(const Vec<D>& x, const Vec<D>& u) const {
    constexpr double nearest = 0.01;
    Vec<D> a{};
    for (const BoundaryPlane& plane : planes_) {
        const double q = std::max(plane.distance<D>(x) / reach_, nearest);
        if (q >= 1.0) continue;
        const double below = std::clamp((depth_ - x[D - 1]) / depth_ + 0.02, 0.02, 1.0);
        const double approach = std::clamp(-20.0 * plane.inward * u[plane.axis] / sound_speed_, 0.0, 1.0);
        a[plane.axis] += plane.inward * strength_ * (1.0 - q) / std::sqrt(q) * (below + approach);
    }
    return a;
}

template class RepulsiveWalls<2>;
template class RepulsiveWalls<3>;

}  // namespace riffle::inline boundary
