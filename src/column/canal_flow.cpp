#include "column/canal_flow.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle {

std::optional<CanalFlow> canal_flow(const Case& c) {
    const Solid* const canal = canal_of(c);
    if (canal == nullptr) {
        return std::nullopt;
    }
    CanalFlow flow;
    const CrossSection section = cross_section(c, *canal);
    const double level = c.total_depth();
    flow.wet = wetted_section(section, level);
    // The upright sides of the channel above the section; the middle of half a channel is none.
    double sides = std::max(0.0, level - section.levels.front());
    if (c.channel.sides == Sides::half) {
        flow.wet.area *= 2.0;
        flow.wet.perimeter *= 2.0;
        flow.wet.top_width *= 2.0;
        sides *= 2.0;
    } else {
        sides += std::max(0.0, level - section.levels.back());
    }
    const bool sides_rub = c.channel.sides != Sides::periodic && c.side_walls.drag_form != SideDragForm::none;
    const double perimeter = flow.wet.perimeter + (sides_rub ? sides : 0.0);
    if (flow.wet.area <= 0.0 || perimeter <= 0.0) {
        return std::nullopt;
    }
    flow.hydraulic_radius = flow.wet.area / perimeter;
    // A water without viscosity has the friction of a very large Reynolds number.
    const double viscosity = std::max(c.fluid.kinematic_viscosity, 1e-12);
    const double weight = c.streamwise_gravity();
    flow.velocity = 10.0 * friction_velocity_from_slope(weight, flow.hydraulic_radius);
    try {
        // The factor depends on the velocity by its logarithm: each turn gains two digits.
        constexpr int turns = 20;
        for (int turn = 0; turn < turns; ++turn) {
            const double reynolds = reynolds_number(flow.velocity, 4.0 * flow.hydraulic_radius, viscosity);
            const double factor = colebrook_white_friction_factor(canal->equivalent_roughness,
                                                                  flow.hydraulic_radius, reynolds, full_pipe);
            flow.velocity = velocity_from_friction_factor(weight, flow.hydraulic_radius, factor);
        }
    } catch (const Error&) {
        return std::nullopt;
    }
    flow.discharge = flow.velocity * flow.wet.area;
    return flow;
}

}  // namespace riffle
