#include "ends/end_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ends/end_lattice.hpp"

namespace riffle::inline ends {

EndRelaxation end_relaxation(const Case& c, const std::optional<TimeTable>& tailwater) {
    constexpr double times_inflow = 5.0;    // of sqrt(H/g)
    constexpr double times_outflow = 80.0;  // of a rise as long as five depths 5 % come back
    constexpr double share = 0.005;         // of the way from low to high water
    const double depth = c.total_depth();
    const double unit = std::sqrt(depth / c.normal_gravity());
    const double passage = tailwater ? tailwater->fastest_passage() : 0.0;
    const double following =
        passage > 0.0 ? std::max(unit, share * passage) : std::numeric_limits<double>::infinity();
    const double along = c.channel.length / waves_of(c).speed(depth);
    return {c.inflow.relaxation_time.value_or(std::min(times_inflow * unit, following)),
            c.outflow.relaxation_time.value_or(std::min(std::max(times_outflow * unit, along), following))};
}

}  // namespace riffle::inline ends
