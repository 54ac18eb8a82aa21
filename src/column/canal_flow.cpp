#include "column/canal_flow.hpp"

#include <algorithm>
#include <cmath>

#include "case/surface_roughness.hpp"
#include "column/canal_channel.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::inline column {

std::optional<CanalFlow> canal_flow(const Case& c) {
    const Solid* const canal = canal_of(c);
    if (canal == nullptr || c.channel.ends != Ends::periodic) return std::nullopt;
    CanalFlow flow;
    const CrossSection section = cross_section(c, *canal);
    const double level = c.total_depth();
    const double lowest = *std::min_element(section.levels.begin(), section.levels.end());
    flow.wet = wetted_section(section, level);
    const WettedSides sides = wetted_sides(c, section, level);
    flow.wet.perimeter += sides.left + sides.right;
    if (c.channel.sides == Sides::half) {
        flow.wet.area *= 2.0;
        flow.wet.perimeter *= 2.0;
        flow.wet.top_width *= 2.0;
    }
    if (flow.wet.area <= 0.0) return std::nullopt;
    flow.hydraulic_radius = flow.wet.area / flow.wet.perimeter;
    // A smooth canal without viscosity holds nothing back.
    flow.velocity = share_of_patches(c, level - lowest) *
                    colebrook_white_velocity(c.streamwise_gravity(), surface_roughness(c, *canal),
                                             flow.hydraulic_radius, c.fluid.kinematic_viscosity, full_pipe);
    if (!(flow.velocity > 0.0 && std::isfinite(flow.velocity))) return std::nullopt;
    flow.discharge = flow.velocity * flow.wet.area;
    flow.alone = c.vegetation.empty() && c.porous.empty();
    return flow;
}

}  // namespace riffle::inline column
