#include "column/column_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/error.hpp"

namespace riffle {

namespace {

/// 0, H and the heights between them where a coefficient is not smooth, in order.
std::vector<double> breakpoints(const Case& c) {
    const double depth = c.total_depth();
    std::vector<double> heights{0.0, c.turbulence.zero, c.datum(), c.crest(), depth};
    if (c.turbulence.closure == ClosureKind::ramp) {
        heights.push_back(c.turbulence.zero +
                          c.turbulence.lambda / c.turbulence.kappa * (depth - c.turbulence.zero));
    }
    std::sort(heights.begin(), heights.end());
    // Heights that coincide but for rounding are one; so are those outside the water.
    std::vector<double> result{0.0};
    const double tolerance = 1e-6 * depth;
    for (const double z : heights) {
        if (z > result.back() + tolerance && z < depth - tolerance) result.push_back(z);
    }
    result.push_back(depth);
    return result;
}

}  // namespace

ColumnGrid make_column_grid(const Case& c, int cells) {
    if (!(c.datum() >= 0.0) || !(c.total_depth() > c.datum())) {
        throw InputError(
            fmt::format("the column needs water above a datum at or above the bed level, but the datum "
                        "stands at {:.6g} m "
                        "and the surface at {:.6g} m: check channel.depth, bed.roughness_height and "
                        "bed.datum_below_crest",
                        c.datum(), c.total_depth()));
    }
    const std::vector<double> heights = breakpoints(c);
    const auto segments = static_cast<double>(heights.size() - 1);
    ColumnGrid grid;
    grid.face.push_back(0.0);
    for (std::size_t s = 0; s + 1 < heights.size(); ++s) {
        const double low = heights[s];
        const double length = heights[s + 1] - low;
        // Half of the cells evenly over the segments, half by length.
        const double share = 0.5 / segments + 0.5 * length / c.total_depth();
        const int n = std::max(4, static_cast<int>(std::lround(share * cells)));
        for (int i = 1; i < n; ++i) {
            grid.face.push_back(low + 0.5 * length * (1.0 - std::cos(std::numbers::pi * i / n)));
        }
        grid.face.push_back(heights[s + 1]);
    }
    for (std::size_t i = 0; i + 1 < grid.face.size(); ++i) {
        grid.centre.push_back(0.5 * (grid.face[i] + grid.face[i + 1]));
    }
    return grid;
}

}  // namespace riffle
