#include "ends/relaxation_between_ends.hpp"

#include <algorithm>

#include "case/end_floor.hpp"
#include "case/flow_kind.hpp"
#include "ends/end_input.hpp"
#include "ends/end_lattice.hpp"

namespace riffle::inline ends {

namespace {

/// Mean depth of the water of the start over what it stands on, m.
double mean_depth_of_start(const Case& c, const EndInput& input) {
    if (is_duct(c)) return c.total_depth();
    constexpr int places = 200;
    const auto level = start_depths(c, input);
    double sum = 0.0;
    for (int i = 0; i < places; ++i) {
        const double x = c.channel.length * (i + 0.5) / places;
        sum += std::max(0.0, level(x) - floor_at(c, x));
    }
    return sum / places;
}

}  // namespace

double relaxation_time_between_ends(const Case& c) {
    const EndInput input = read_end_levels(c);
    const double depth = mean_depth_of_start(c, input);
    const LongWaves waves = waves_of(c);
    const double discharge = start_unit_discharge(c, input);
    double time = c.channel.length / waves.speed(c.total_depth());
    if (discharge > 0.0) time = std::max(time, waves.area(depth) * c.channel.length / discharge);
    // What falls over an edge or shoots off is ruled by nothing there.
    return input.outflow_depth ? std::max(time, input.relaxation_time) : time;
}

}  // namespace riffle::inline ends
