#include "roughness/side_wall_partition.hpp"

#include <cmath>

namespace riffle::inline roughness {

namespace {

/// The real root of k^3 + a k^2 + b k + c by Newton's steps from above, where the cubic is convex and grows,
/// so that they fall onto it.
double root_below(double start, double a, double b, double c) {
    double k = start;
    for (int i = 0; i < 50; ++i) {
        const double step = (((k + a) * k + b) * k + c) / ((3.0 * k + 2.0 * a) * k + b);
        k -= step;
        if (std::abs(step) < 1e-15) break;
    }
    return k;
}

}  // namespace

SideWallPartition side_wall_partition(double depth, double width, double streamwise_gravity) {
    constexpr double above_all = 1.3;  // k lies between 0.79 and 1.26, the cube roots of 1/2 and 2
    SideWallPartition p;
    const double whole = width * depth;
    // The lines from the corners go k wide for 1 up.
    if (width >= 2.0 * depth) {
        p.k = root_below(above_all, 0.0, 2.0 * depth / width, -2.0);
        p.wall_area = 0.5 * p.k * depth * depth;
        p.bed_area = whole - 2.0 * p.wall_area;
    } else {
        p.k = root_below(above_all, -0.25 * width / depth, 0.0, -0.5);
        p.bed_area = 0.25 * width * width / p.k;
        p.wall_area = 0.5 * (whole - p.bed_area);
    }
    p.bed_stress = streamwise_gravity * p.bed_area / width;
    p.wall_stress = streamwise_gravity * p.wall_area / depth;
    p.bed_share = p.bed_area / whole;
    p.wall_over_bed = depth / (p.k * p.k * width);
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
