#include "analysis/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "boundary/wall_motion.hpp"
#include "case/body_state.hpp"
#include "case/flow_kind.hpp"
#include "case/solid_motion.hpp"

namespace riffle::inline analysis {

namespace {

Outline placed(Outline outline, const BodyState& body) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec<3> corner = body.placed({outline.x[i], 0.0, outline.z[i]});
        outline.x[i] = corner[0];
        outline.z[i] = corner[2];
    }
    return outline;
}

}  // namespace

std::vector<Outline> outlines_at(const Case& c, double time) {
    std::vector<Outline> outlines;
    if (c.channel.dimensions != 2) return outlines;
    const std::vector<BodyState> bodies = WallMotion(c).at(time);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        outlines.push_back(
            placed({c.solids[k].x, c.solids[k].z}, bodies[static_cast<std::size_t>(first_solid) + k]));
    }
    return outlines;
}

std::vector<Outline> prescribed_outlines_at(const Case& c, double time) {
    std::vector<Outline> all = outlines_at(c, time);
    std::vector<Outline> prescribed;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (!c.solids[k].is_free()) prescribed.push_back(std::move(all[k]));
    }
    return prescribed;
}

namespace {

/// The last value that the instruments have recorded of a quantity up to a time; nothing without one.
std::optional<double> recorded_at(const FlowRecord& record, const std::string& quantity, double time) {
    std::optional<double> value;
    for (const ScalarProbe& probe : record.scalar_probes()) {
        if (probe.quantity != quantity) continue;
        const auto after = std::upper_bound(probe.time.begin(), probe.time.end(), time);
        if (after != probe.time.begin()) {
            value = probe.value[static_cast<std::size_t>(after - probe.time.begin()) - 1];
        }
    }
    return value;
}

/// A free body of a plane where it stood at a time, in a periodic channel within it; nothing where no
/// instrument recorded it.
std::optional<Outline> recorded_outline(const FlowRecord& record, std::size_t solid, double time) {
    const Case& c = *record.flow();
    const auto value = [&](const char* name) {
        return recorded_at(record, fmt::format("{}_{}", name, solid + 1), time);
    };
    const auto x = value("body_x");
    const auto z = value("body_z");
    const auto angle = value("body_angle_y");
    if (!x || !z || !angle) return std::nullopt;
    const double length = c.channel.length;
    const double around = c.channel.ends == Ends::periodic ? length * std::floor(*x / length) : 0.0;
    const Point3 centre = rotation_point(c, c.solids[solid]);
    return placed({c.solids[solid].x, c.solids[solid].z},
                  {.displacement = {*x - around - centre[0], 0.0, *z - centre[2]},
                   .velocity = {},
                   .acceleration = {},
                   .turns = true,
                   .centre = centre,
                   .rotation = rotation_about({0.0, 1.0, 0.0}, *angle)});
}

}  // namespace

std::vector<Curve> body_curves(const FlowRecord& record, double time, double time_of_free) {
    const Case& c = *record.flow();
    std::vector<Curve> curves;
    std::vector<Outline> outlines = outlines_at(c, time);
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        if (c.solids[k].is_free()) {
            auto free = recorded_outline(record, k, time_of_free);
            if (!free) continue;
            outlines[k] = std::move(*free);
        }
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
