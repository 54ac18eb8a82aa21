#include "column/column_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "case/bed_traits.hpp"
#include "case/porous_zone.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline column {

std::vector<double> distinct_between(std::vector<double> points, double from, double to) {
    std::sort(points.begin(), points.end());
    std::vector<double> result{from};
    const double tolerance = 1e-6 * (to - from);
    for (const double p : points) {
        if (p > result.back() + tolerance && p < to - tolerance) result.push_back(p);
    }
    result.push_back(to);
    return result;
}

std::vector<double> column_breakpoints(const Case& c) {
    const double depth = c.total_depth();
    std::vector<double> heights{c.turbulence.zero, c.datum(), c.crest()};
    if (c.turbulence.closure == ClosureKind::ramp) {
        heights.push_back(c.turbulence.zero +
                          c.turbulence.lambda / c.turbulence.kappa * (depth - c.turbulence.zero));
    }
    if (c.channel.dimensions == 3 && has_spheres(c.bed)) {
        // The ends of the ramp over which the drag of a sphere sets in.
        heights.push_back(c.crest() - 0.5 * c.sphere_ramp());
        heights.push_back(c.crest() + 0.5 * c.sphere_ramp());
    }
    for (const Vegetation& stems : c.vegetation) heights.push_back(stems.height);
    for (const Porous& layer : c.porous) {
        const double half = 0.5 * porous_edge(c, layer);
        for (const auto& surface : {layer.z_from, layer.z_to}) {
            if (!surface) continue;
            for (const double height : {*surface - half, *surface, *surface + half}) {
                heights.push_back(height);
            }
        }
        if (!layer.top_z.empty()) {
            for (const double part : {-half, 0.0, half}) heights.push_back(layer.top_z.front() + part);
        }
    }
    if (const auto law = bed_wall_law(c)) {
        // The layers of the law, each ten times as high as the one below it.
        constexpr double share_of_depth = 0.1;
        const double lowest = std::max(law->shift, law->viscous_length);
        for (double height = lowest; lowest > 0.0 && height < share_of_depth * depth; height *= 10.0) {
            heights.push_back(height);
        }
    }
    return distinct_between(std::move(heights), 0.0, depth);
}

std::vector<double> graded_faces(const std::vector<double>& breakpoints, int cells, int fewest, double even) {
    const auto segments = static_cast<double>(breakpoints.size() - 1);
    const double extent = breakpoints.back() - breakpoints.front();
    std::vector<double> faces{breakpoints.front()};
    for (std::size_t s = 0; s + 1 < breakpoints.size(); ++s) {
        const double low = breakpoints[s];
        const double length = breakpoints[s + 1] - low;
        const double share = even / segments + (1.0 - even) * length / extent;
        const int n = std::max(fewest, static_cast<int>(std::lround(share * cells)));
        for (int i = 1; i < n; ++i) {
            faces.push_back(low + 0.5 * length * (1.0 - std::cos(std::numbers::pi * i / n)));
        }
        faces.push_back(breakpoints[s + 1]);
    }
    return faces;
}

std::vector<double> midpoints(const std::vector<double>& faces) {
    std::vector<double> centres;
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) centres.push_back(0.5 * (faces[i] + faces[i + 1]));
    return centres;
}

ColumnGrid make_column_grid(const Case& c, int cells) {
    if (!(c.datum() >= 0.0) || !(c.total_depth() > c.datum())) {
        throw InputError(
            fmt::format("the column needs water above a datum at or above the bed level, but the datum "
                        "stands at {:.6g} m and the surface at {:.6g} m: check channel.depth, "
                        "bed.roughness_height and bed.datum_below_crest",
                        c.datum(), c.total_depth()));
    }
    constexpr int fewest = 4;
    ColumnGrid grid;
    grid.face = graded_faces(column_breakpoints(c), cells, fewest);
    grid.centre = midpoints(grid.face);
    return grid;
}

}  // namespace riffle::inline column
