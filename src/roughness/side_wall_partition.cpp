#include "roughness/side_wall_partition.hpp"

#include <cmath>

namespace riffle::inline roughness {

SideWallPartition side_wall_partition(double depth, double width, double streamwise_gravity) {
    // Newton from above: the cubic is convex and increasing there, so the steps fall onto its one real root.
    const double slope = 2.0 * depth / width;
    double k = 1.3;  // the root of k^3 = 2 is 1.26, and slope > 0 makes it smaller
    for (int i = 0; i < 50; ++i) {
        const double step = (k * k * k + slope * k - 2.0) / (3.0 * k * k + slope);
        k -= step;
        if (std::abs(step) < 1e-15) break;
    }
    SideWallPartition p;
    p.k = k;
    p.wall_area = 0.5 * k * depth * depth;
    p.bed_area = width * depth - 2.0 * p.wall_area;
    p.bed_stress = streamwise_gravity * p.bed_area / width;
    p.wall_stress = streamwise_gravity * p.wall_area / depth;
    p.bed_share = p.bed_area / (width * depth);
    p.wall_over_bed = depth / (k * k * width);
    return p;
}

SideWallPartition side_wall_partition(const Case& c) {
    return side_wall_partition(c.total_depth(), c.channel.width, c.streamwise_gravity());
}

double printed_side_wall_coefficient(const Case& c) {
    const SideWallPartition p = side_wall_partition(c);
    return p.wall_area / (p.k * p.k * p.bed_area) * c.bed.drag_coefficient / (2.0 * c.numerics.spacing);
}

}  // namespace riffle::inline roughness
