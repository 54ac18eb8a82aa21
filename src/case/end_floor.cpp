#include "case/end_floor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "case/outline.hpp"

namespace riffle::inline case_file {

namespace {

/// A height just above the bed, m: a solid that stands on it contains it.
constexpr double just_above = 1e-9;

}  // namespace

double floor_at(const Case& c, double x) {
    double floor = 0.0;
    if (c.channel.dimensions == 3) return floor;
    for (const Solid& solid : c.solids) {
        const Outline outline{solid.x, solid.z};
        if (contains(outline, x, just_above)) floor = std::max(floor, ceiling_above(outline, x, just_above));
    }
    return floor;
}

EndFloors end_floors(const Case& c) {
    if (c.channel.ends != Ends::open) {
        return {};
    }
    return {floor_at(c, within_ends(0.0, c.channel.length)),
            floor_at(c, within_ends(c.channel.length, c.channel.length))};
}

bool carries_through(const Solid& solid, double from, double to) {
    const Outline outline{solid.x, solid.z};
    if (!contains(outline, 0.5 * (from + to), just_above)) return false;
    // The faces of its top over the stretch: level, at one height, from end to end.
    std::optional<double> height;
    double left_end = to;
    double right_end = from;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const auto [left, right] = std::minmax(outline.x[i], outline.x[j]);
        const bool above = std::max(outline.z[i], outline.z[j]) > just_above;
        if (!above || right <= from || left >= to) continue;
        if (outline.z[i] != outline.z[j] || outline.z[i] != height.value_or(outline.z[i])) return false;
        height = outline.z[i];
        left_end = std::min(left_end, left);
        right_end = std::max(right_end, right);
    }
    return left_end <= from && right_end >= to;
}

bool passes_through(const Case& c, const Solid& solid) {
    if (c.channel.dimensions == 3 || c.channel.ends != Ends::periodic || !solid.rests() || solid.x.empty()) {
        return false;
    }
    const double length = c.channel.length;
    const double reach = c.numerics.wall_layers * c.numerics.spacing;
    const auto [low, high] = std::minmax_element(solid.x.begin(), solid.x.end());
    if (*low > -reach || *high < length + reach) return false;
    const Outline outline{solid.x, solid.z};
    const auto top = [&](double x) {
        return contains(outline, x, just_above) ? ceiling_above(outline, x, just_above) : 0.0;
    };
    // In steps that are no fraction of what outlines are drawn by.
    const double step = 0.1234567 * c.numerics.spacing;
    for (double x = 0.5 * step; x < reach; x += step) {
        const double tolerance = 0.1 * c.numerics.spacing;
        if (std::abs(top(x) - top(length + x)) > tolerance ||
            std::abs(top(-x) - top(length - x)) > tolerance) {
            return false;
        }
    }
    return true;
}

}  // namespace riffle::inline case_file
