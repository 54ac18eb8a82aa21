#include "ends/end_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/bed_patch.hpp"
#include "case/cross_section.hpp"
#include "case/end_floor.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "column/twin_channel.hpp"
#include "column/uniform_rating.hpp"
#include "ends/end_lattice.hpp"

namespace riffle::inline ends {

namespace {

/// The depth to which a discharge shoots off between the ends, where the channel is so steep that uniform
/// flow is supercritical: that of uniform flow over the faster bed of both ends, without the side walls'
/// drag; where nothing holds the water back, neither bed nor outflow, that of its free fall along the
/// channel. Infinite on a mild slope.
double shooting_depth(const Case& c, const LongWaves& waves, double q) {
    const double critical = waves.critical_depth(q);
    double depth = std::numeric_limits<double>::infinity();
    if (!(c.streamwise_gravity() > 0.0) || !(q > 0.0)) return depth;
    if (canal_of(c) != nullptr) {
        return uniform_discharge_at(c, critical) > q ? UniformRating(c).depth(q) : depth;
    }
    if (!waves.in_rectangle()) {
        const double begin = q / waves.area(critical);
        const double fall = 2.0 * c.streamwise_gravity() * c.channel.length;
        return waves.depth_of_area(q / std::sqrt(begin * begin + fall));
    }
    for (const double place : {0.0, c.channel.length}) {
        Case bed = with_bed_at(c, place);
        bed.channel.sides = Sides::periodic;
        bed.channel.dimensions = 2;
        bed.bed_patches.clear();
        if (!channel_resists(bed)) {
            if (c.outflow.kind != OutflowKind::free && c.outflow.kind != OutflowKind::free_fall) continue;
            const double begin = q / critical;
            const double fall = 2.0 * c.streamwise_gravity() * c.channel.length;
            depth = std::min(depth, q / std::sqrt(begin * begin + fall));
        } else if (!resolves_eddies(c) && critical > 2.0 * c.datum() &&
                   uniform_discharge_at(bed, critical - c.datum()) > q) {
            depth = std::min(depth, UniformRating(bed).depth(q) + c.datum());
        }
    }
    return depth;
}

}  // namespace

EndExtremes end_extremes(const Case& c, const EndInput& input) {
    const double q = input.unit_discharge ? input.unit_discharge->largest() : start_unit_discharge(c, input);
    const EndFloors floors = end_floors(c);
    const double floor = std::max(floors.upstream, floors.downstream);
    EndExtremes extremes{.depth = c.total_depth(), .velocity = 0.0};
    double least_depth = c.total_depth() - floor;
    if (is_duct(c)) {
        extremes.velocity = std::max({input.entering->largest() * q / least_depth, input.jet_velocity,
                                      c.start.velocity.value_or(0.0)});
        return extremes;
    }
    if (input.inflow_depth) {
        extremes.depth = std::max(extremes.depth, floors.upstream + input.inflow_depth->largest());
        least_depth = std::min(least_depth, input.inflow_depth->smallest());
    }
    if (input.outflow_table) {
        extremes.depth = std::max(extremes.depth, floors.downstream + input.outflow_table->largest());
    } else if (input.outflow_depth) {
        const double depth = input.outflow_depth(q, 0.0);
        extremes.depth = std::max(extremes.depth, floors.downstream + depth);
        least_depth = std::min(least_depth, depth);
    }
    // Water that rises to carry a flood moves no faster than critical flow, unless it comes in so.
    const LongWaves waves = waves_of(c);
    const double critical = waves.critical_depth(q);
    extremes.depth = std::max(extremes.depth, floor + critical);
    const double shallow = input.inflow_depth
                               ? least_depth
                               : std::min(std::max(least_depth, critical), shooting_depth(c, waves, q));
    const double area = waves.area(shallow);
    extremes.velocity =
        std::max(area > 0.0 ? input.entering->largest() * q / area : 0.0, c.start.velocity.value_or(0.0));
    return extremes;
}

}  // namespace riffle::inline ends
