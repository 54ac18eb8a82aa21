#include "boundary/plane_contact.hpp"

#include <algorithm>

namespace riffle::inline boundary {

template <int D>
PlaneContact<D>::PlaneContact(const Case& c) : spacing_(c.numerics.spacing) {
    if (c.numerics.wall != WallKind::repulsive) planes_ = boundary_planes<D>(c);
}

template <int D>
double PlaneContact<D>::resolve(Vec<D>& position, Vec<D>& velocity) const {
    double deepest = 0.0;
    for (const BoundaryPlane& plane : planes_) {
        const double depth = -plane.distance<D>(position);
        if (depth > 0.25 * spacing_ && depth <= spacing_ && position[D - 1] <= plane.top &&
            position[0] <= plane.end) {
            position[plane.axis] = plane.place;
            velocity[plane.axis] = plane.inward * std::max(plane.inward * velocity[plane.axis], 0.0);
            deepest = std::max(deepest, depth);
        }
    }
    return deepest;
}

template class PlaneContact<2>;
template class PlaneContact<3>;

}  // namespace riffle::inline boundary
