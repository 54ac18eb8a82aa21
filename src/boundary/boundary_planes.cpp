#include "boundary/boundary_planes.hpp"

#include "boundary/wall.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline boundary {

template <int D>
std::vector<BoundaryPlane> boundary_planes(const Case& c) {
    std::vector<BoundaryPlane> planes;
    if (c.channel.top == Top::periodic) return planes;
    constexpr auto vertical = static_cast<std::size_t>(D - 1);
    const double top = end_wall_height(c);
    planes.push_back({vertical, 0.0, 1.0});
    if (bed_ends(c)) planes.back().end = c.channel.length;
    if (c.channel.top == Top::wall) {
        planes.push_back({vertical, c.total_depth(), -1.0});
    }
    const auto add_two = [&](std::size_t axis, double extent) {
        planes.push_back({axis, 0.0, 1.0, top});
        planes.push_back({axis, extent, -1.0, top});
    };
    if (c.channel.ends == Ends::walls) add_two(0, c.channel.length);
    if (D == 3 && c.channel.sides != Sides::periodic) add_two(1, c.channel.simulated_width());
    return planes;
}

template std::vector<BoundaryPlane> boundary_planes<2>(const Case&);
template std::vector<BoundaryPlane> boundary_planes<3>(const Case&);

}  // namespace riffle::inline boundary
