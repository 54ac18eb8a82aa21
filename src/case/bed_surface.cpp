#include "case/bed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "case/cross_section.hpp"
#include "case/end_buffers.hpp"
#include "case/polygon.hpp"

namespace riffle::inline case_file {

namespace {

/// So far bodies reach beyond the channel, m.
double reach_beyond(const Case& c) {
    const double walls = c.numerics.wall_layers * c.numerics.spacing;
    // Beyond open ends as much farther as no wall particle there sees where it ends.
    return (c.channel.ends == Ends::open ? walls_beyond_end(c) : 0.0) + walls + c.numerics.spacing;
}

/// Regular places from beyond the one end of a channel to beyond the other, and which of the places of the
/// channel, 0 to `steps`, has their height.
struct BeyondPlaces {
    std::vector<double> at;
    std::vector<std::size_t> same;

    BeyondPlaces(std::size_t steps, double step, double reach, bool periodic) {
        const auto more = static_cast<std::ptrdiff_t>(std::ceil(reach / step - 1e-9));
        const auto last = static_cast<std::ptrdiff_t>(steps);
        for (std::ptrdiff_t i = -more; i <= last + more; ++i) {
            at.push_back(static_cast<double>(i) * step);
            const std::ptrdiff_t inside =
                periodic ? ((i % last) + last) % last : std::clamp<std::ptrdiff_t>(i, 0, last);
            same.push_back(static_cast<std::size_t>(inside));
        }
    }
};

/// Whether b lies on the way from a to c.
bool on_line(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    const double across = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return std::abs(across) <= 1e-12 * ((c[0] - a[0]) * (c[0] - a[0]) + (c[1] - a[1]) * (c[1] - a[1]));
}

}  // namespace

Triangles bed_triangles(const Case& c, const BedHeights& bed) {
    const double reach = reach_beyond(c);
    const double bottom = -reach;
    const BeyondPlaces x(bed.columns, bed.step_x, reach, c.channel.ends == Ends::periodic);
    const BeyondPlaces y(bed.rows, bed.step_y, reach, c.channel.sides == Sides::periodic);
    const auto top = [&](std::size_t i, std::size_t j) {
        return Point3{x.at[i], y.at[j], bed.at(x.same[i], y.same[j])};
    };
    const auto below = [&](std::size_t i, std::size_t j) { return Point3{x.at[i], y.at[j], bottom}; };
    const std::size_t right = x.at.size() - 1;
    const std::size_t far = y.at.size() - 1;
    Triangles triangles;
    triangles.reserve(2 * right * far + 6 * (right + far));
    for (std::size_t j = 0; j < far; ++j) {
        for (std::size_t i = 0; i < right; ++i) {
            triangles.push_back({top(i, j), top(i + 1, j), top(i + 1, j + 1)});
            triangles.push_back({top(i, j), top(i + 1, j + 1), top(i, j + 1)});
        }
    }
    const Point3 middle{0.5 * (x.at.front() + x.at.back()), 0.5 * (y.at.front() + y.at.back()), bottom};
    // A side of it below the edge from one place to the next, with the part of the bottom behind it.
    const auto side = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        triangles.push_back({top(i, j), below(i, j), below(k, l)});
        triangles.push_back({top(i, j), below(k, l), top(k, l)});
        triangles.push_back({below(i, j), middle, below(k, l)});
    };
    for (std::size_t i = 0; i < right; ++i) {
        side(i, 0, i + 1, 0);
        side(i + 1, far, i, far);
    }
    for (std::size_t j = 0; j < far; ++j) {
        side(right, j, right, j + 1);
        side(0, j + 1, 0, j);
    }
    return triangles;
}

Outline bed_outline(const Case& c, const BedHeights& bed) {
    const double reach = reach_beyond(c);
    const BeyondPlaces x(bed.columns, bed.step_x, reach, c.channel.ends == Ends::periodic);
    std::vector<PlanePoint> corners{{x.at.front(), -reach}, {x.at.back(), -reach}};
    for (std::size_t i = x.at.size(); i-- > 0;) {
        const PlanePoint corner{x.at[i], bed.at(x.same[i], 0)};
        // Where a periodic channel begins and ends the fill stops: a corner stays there.
        const bool at_end = x.at[i] == 0.0 || i + 1 == x.at.size() || i == 0;
        if (corners.size() > 3 && on_line(corners[corners.size() - 2], corners.back(), corner) && !at_end &&
            corners.back()[0] != 0.0 && corners.back()[0] != bed.step_x * static_cast<double>(bed.columns)) {
            corners.back() = corner;
        } else {
            corners.push_back(corner);
        }
    }
    Outline outline;
    for (const PlanePoint& corner : corners) {
        outline.x.push_back(corner[0]);
        outline.z.push_back(corner[1]);
    }
    return outline;
}

Triangles section_triangles(const Case& c, const Solid& solid) {
    const double reach = reach_beyond(c);
    const auto [y, levels] = cross_section(c, solid);
    // Against the clock as seen from the end of the channel: below it from left to right, then back.
    std::vector<PlanePoint> corners{{y.front() - reach, -reach}, {y.back() + reach, -reach}};
    corners.push_back({y.back() + reach, levels.back()});
    for (std::size_t i = y.size(); i-- > 0;) {
        corners.push_back({y[i], levels[i]});
    }
    corners.push_back({y.front() - reach, levels.front()});
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    const double begin = -reach;
    const double end = c.channel.length + reach;
    const auto place = [&](std::size_t i, double x) { return Point3{x, corners[i][0], corners[i][1]}; };
    Triangles triangles;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t j = (i + 1) % corners.size();
        triangles.push_back({place(i, begin), place(j, begin), place(j, end)});
        triangles.push_back({place(i, begin), place(j, end), place(i, end)});
    }
    for (const auto& part : polygon_triangles(corners)) {
        triangles.push_back({place(part[0], end), place(part[1], end), place(part[2], end)});
        triangles.push_back({place(part[0], begin), place(part[2], begin), place(part[1], begin)});
    }
    return triangles;
}

}  // namespace riffle::inline case_file
