#include "boundary/plane_contact.hpp"

#include <algorithm>

#include "boundary/wall.hpp"

namespace riffle {

template <int D>
PlaneContact<D>::PlaneContact(const Case& c) : spacing_(c.numerics.spacing) {
    if (c.channel.top == Top::periodic || c.numerics.wall == WallKind::repulsive) {
        return;
    }
    constexpr auto vertical = static_cast<std::size_t>(D - 1);
    const double top = end_wall_height(c);
    planes_.push_back({vertical, 0.0, 1.0});
    if (c.channel.top == Top::wall) {
        planes_.push_back({vertical, c.total_depth(), -1.0});
    }
    if (c.channel.ends == Ends::walls) {
        planes_.push_back({0, 0.0, 1.0, top});
        planes_.push_back({0, c.channel.length, -1.0, top});
    }
    if constexpr (D == 3) {
        if (c.channel.sides != Sides::periodic) {
            planes_.push_back({1, 0.0, 1.0, top});
            planes_.push_back({1, c.channel.simulated_width(), -1.0, top});
        }
    }
}

template <int D>
double PlaneContact<D>::resolve(Vec<D>& position, Vec<D>& velocity) const {
    double deepest = 0.0;
    for (const Plane& plane : planes_) {
        const double depth = plane.inward * (plane.place - position[plane.axis]);
        if (depth > 0.25 * spacing_ && depth <= spacing_ && position[D - 1] <= plane.top) {
            position[plane.axis] = plane.place;
            velocity[plane.axis] = plane.inward * std::max(plane.inward * velocity[plane.axis], 0.0);
            deepest = std::max(deepest, depth);
        }
    }
    return deepest;
}

template class PlaneContact<2>;
template class PlaneContact<3>;

}  // namespace riffle
