#include "boundary/solid_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/solid_fill.hpp"

namespace riffle::inline boundary {

SolidContact::SolidContact(const Case& c)
    : spacing_(c.numerics.spacing), period_(c.channel.ends == Ends::periodic ? c.channel.length : 0.0) {
    for (const Solid& solid : c.solids) {
        Body body{.outline = outline_of(solid), .wetted = {}};
        for (std::size_t i = 0; i < body.outline.size(); ++i) {
            body.wetted.push_back(is_wetted(c, solid, body.outline, i));
            const double high = std::max(body.outline.z[i], body.outline.z[body.outline.next(i)]);
            body.stands_on_bed = body.stands_on_bed || (!body.wetted[i] && high <= 1e-6 * spacing_);
        }
        const auto [left, right] = std::minmax_element(solid.x.begin(), solid.x.end());
        body.left = *left;
        body.right = *right;
        bodies_.push_back(std::move(body));
    }
}

std::optional<Vec<2>> SolidContact::inside(const Body& body, const BodyState& state,
                                           const Vec<2>& position) const {
    const double beside =
        state.turns ? image_near(state.centre[0] + state.displacement[0], position[0], period_) : position[0];
    const Vec<3> start = state.place_at_start({beside, 0.0, position[1]});
    double x = start[0];
    double z = start[2];
    // A drop that has hit the bed and is squeezed into it must not slip under what stands on it.
    if (body.stands_on_bed) z = std::max(z, 1e-6 * spacing_);
    if (period_ > 0.0 && !state.turns) x -= period_ * std::floor((x - body.left) / period_);
    return x < body.left || x > body.right || !contains(body.outline, x, z) ? std::nullopt
                                                                            : std::optional(Vec<2>{x, z});
}

double SolidContact::depth(std::size_t solid, const std::vector<BodyState>& now,
                           const Vec<2>& position) const {
    const Body& body = bodies_[solid];
    const auto place = inside(body, now[first_solid + solid], position);
    return place ? distance_from_outline(body.outline, (*place)[0], (*place)[1]) : 0.0;
}

double SolidContact::resolve(const std::vector<BodyState>& now, Vec<2>& position, Vec<2>& velocity,
                             const Push& push) const {
    double deepest = 0.0;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const Body& body = bodies_[k];
        const BodyState& state = now[first_solid + k];
        const auto place = inside(body, state, position);
        if (!place) continue;
        double depth = std::numeric_limits<double>::infinity();
        std::size_t edge = 0;
        for (std::size_t i = 0; i < body.outline.size(); ++i) {
            const double distance = distance_from_edge(body.outline, i, (*place)[0], (*place)[1]);
            if (body.wetted[i] && distance < depth) {
                depth = distance;
                edge = i;
            }
        }
        deepest = std::max(deepest, depth);
        if (depth > spacing_) continue;
        const std::size_t end = body.outline.next(edge);
        const double dx = body.outline.x[end] - body.outline.x[edge];
        const double dz = body.outline.z[end] - body.outline.z[edge];
        const Vec<2> normal =
            in_flow<2>(state.turned({dz / std::hypot(dx, dz), 0.0, -dx / std::hypot(dx, dz)}));
        const Vec<3> at = state.placed({(*place)[0], 0.0, (*place)[1]});
        const Vec<3> solid = state.velocity_at(at);
        const double inward = (velocity[0] - solid[0]) * normal[0] + (velocity[1] - solid[2]) * normal[1];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            position[axis] += (depth + 1e-6 * spacing_) * normal[axis];
            velocity[axis] -= std::min(inward, 0.0) * normal[axis];
        }
        if (push) {
            const double gain = -std::min(inward, 0.0);
            push(k, at, {gain * normal[0], 0.0, gain * normal[1]});
        }
    }
    return deepest;
}

}  // namespace riffle::inline boundary
