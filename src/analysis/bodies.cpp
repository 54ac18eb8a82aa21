#include "analysis/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boundary/wall_motion.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline analysis {

std::vector<Outline> outlines_at(const Case& c, double time) {
    std::vector<Outline> outlines;
    if (c.channel.dimensions != 2) return outlines;
    const std::vector<BodyState> bodies = WallMotion(c).at(time);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const BodyState& body = bodies[static_cast<std::size_t>(first_solid) + k];
        Outline outline{c.solids[k].x, c.solids[k].z};
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec<3> corner = body.placed({outline.x[i], 0.0, outline.z[i]});
            outline.x[i] = corner[0];
            outline.z[i] = corner[2];
        }
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

std::vector<Outline> prescribed_outlines_at(const Case& c, double time) {
    std::vector<Outline> all = outlines_at(c, time);
    std::vector<Outline> prescribed;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (c.solids[k].motion != SolidMotion::free) prescribed.push_back(std::move(all[k]));
    }
    return prescribed;
}

std::vector<Curve> body_curves(const Case& c, double time) {
    std::vector<Curve> curves;
    const std::vector<Outline> outlines = outlines_at(c, time);
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        if (c.solids[k].motion == SolidMotion::free) continue;
        Curve curve;
        curve.name = c.solids[k].name;
        curve.origin = Origin::reference;
        curve.mark = Mark::area;
        curve.x = outlines[k].x;
        curve.y = outlines[k].z;
        curve.x.push_back(curve.x.front());
        curve.y.push_back(curve.y.front());
        curves.push_back(std::move(curve));
    }
    return curves;
}

double blocked_height(const std::vector<Outline>& outlines, double x, double up_to) {
    constexpr int steps = 400;
    int inside = 0;
    for (int i = 0; i < steps; ++i) {
        const double z = (i + 0.5) * up_to / steps;
        inside += std::any_of(outlines.begin(), outlines.end(),
                              [&](const Outline& outline) { return contains(outline, x, z); })
                      ? 1
                      : 0;
    }
    return up_to * inside / steps;
}

std::optional<DamBreak> dam_break_of(const Case& c) {
    const std::vector<double>& x = c.start.water_x;
    const std::vector<double>& z = c.start.water_z;
    if (flow_kind(c) != FlowKind::tank || c.channel.ends != Ends::walls || c.channel.slope != 0.0 ||
        c.channel.top != Top::free_surface || x.size() != 4 || z.size() != 4) {
        return std::nullopt;
    }
    const auto [left, right] = std::minmax_element(x.begin(), x.end());
    const auto [low, high] = std::minmax_element(z.begin(), z.end());
    const double hair = 1e-6 * c.channel.length;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const bool corner = (std::abs(x[i] - *left) < hair || std::abs(x[i] - *right) < hair) &&
                            (std::abs(z[i] - *low) < hair || std::abs(z[i] - *high) < hair);
        if (!corner) return std::nullopt;
    }
    const bool at_left = *left < hair;
    const bool at_right = *right > c.channel.length - hair;
    if (*low > hair || at_left == at_right) return std::nullopt;
    DamBreak dam{at_left ? *right : *left, *high, *right - *left, 0.0, at_left};
    // Bodies in the way change the flow; one that stands at the dam and is pulled is its gate.
    for (const Solid& solid : c.solids) {
        if (solid.x.empty()) return std::nullopt;  // in space its outline is that of a file
        const auto [from, to] = std::minmax_element(solid.x.begin(), solid.x.end());
        const double near = 2.0 * c.numerics.spacing;
        const bool gate = solid.motion == SolidMotion::constant && solid.velocity_z > 0.0 &&
                          dam.dam > *from - near && dam.dam < *to + near;
        if (!gate) return std::nullopt;
        dam.opening = std::max(dam.opening, solid.start);
    }
    return dam;
}

}  // namespace riffle::inline analysis
