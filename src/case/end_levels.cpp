#include "case/end_levels.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "case/cross_section.hpp"
#include "case/end_floor.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline case_file {

double critical_depth_of(double gravity, double unit_discharge) {
    return std::cbrt(unit_discharge * unit_discharge / gravity);
}

double critical_depth_of(const Case& c, double unit_discharge) {
    const double g = c.normal_gravity();
    const Solid* const solid = section_of(c);
    if (solid == nullptr || !(unit_discharge > 0.0)) return critical_depth_of(g, unit_discharge);
    const CrossSection section = cross_section(c, *solid);
    const double lowest = *std::min_element(section.levels.begin(), section.levels.end());
    const double width = c.channel.simulated_width();
    const auto subcritical = [&](double depth) {
        const WettedSection wet = wetted_section(section, lowest + depth);
        const double area = wet.area / width;
        return g * area * area * area >= unit_discharge * unit_discharge * wet.top_width / width;
    };
    // Downwards from a depth at which it is, so that over floodplains the largest critical depth is found.
    double high = critical_depth_of(g, unit_discharge);
    while (!subcritical(high)) high *= 2.0;
    double low = high;
    constexpr double ratio = 0.98;
    while (subcritical(low)) {
        high = low;
        low *= ratio;
    }
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (subcritical(middle) ? high : low) = middle;
    }
    return high;
}

double weir_head(double gravity, double discharge_coefficient, double unit_discharge) {
    const double head =
        std::max(0.0, unit_discharge) * 1.5 / (discharge_coefficient * std::sqrt(2.0 * gravity));
    return std::pow(head, 2.0 / 3.0);
}

double highest_end_level(const Case& c) {
    if (c.channel.ends != Ends::open || is_duct(c)) return 0.0;
    double level = 0.0;
    if (c.inflow.depth) level = std::max(level, *c.inflow.depth + c.datum());
    if (c.outflow.kind == OutflowKind::depth && c.outflow.depth) {
        level = std::max(level, *c.outflow.depth + c.datum());
    }
    const double q = c.inflow_unit_discharge().value_or(0.0);
    const double g = c.normal_gravity();
    if (c.outflow.kind == OutflowKind::weir) {
        level =
            std::max(level, c.outflow.weir_height + c.datum() + weir_head(g, c.outflow.weir_coefficient, q));
    }
    if (!c.inflow.depth) {
        const EndFloors floors = end_floors(c);
        level = std::max(level, std::max(floors.upstream, floors.downstream) + critical_depth_of(c, q));
    }
    return level;
}

LeastDepth least_named_depth(const Case& c) {
    LeastDepth least{.depth = c.total_depth()};
    if (c.channel.ends != Ends::open || is_duct(c)) return least;
    const EndFloors floors = end_floors(c);
    const auto consider = [&](const std::optional<double>& level, double floor, const char* of) {
        if (level && *level + c.datum() - floor < least.depth) {
            least = {*level + c.datum() - floor, of};
        }
    };
    consider(c.inflow.depth, floors.upstream, "the inflow");
    if (c.outflow.kind == OutflowKind::depth) consider(c.outflow.depth, floors.downstream, "the outflow");
    return least;
}

bool has_end_tables(const Case& c) {
    return changes_at_ends(c) || (c.channel.ends == Ends::open && !c.outflow.rating_file.empty());
}

bool inflow_changes(const Case& c) {
    return c.channel.ends == Ends::open && !(c.inflow.discharge_file.empty() && c.inflow.depth_file.empty());
}

bool tailwater_changes(const Case& c) {
    return c.channel.ends == Ends::open && !c.outflow.depth_file.empty();
}

bool changes_at_ends(const Case& c) { return inflow_changes(c) || tailwater_changes(c); }

double level_with_room(const Case& c) {
    constexpr double depths = 4.0;
    return depths * std::max(c.total_depth(), highest_end_level(c));
}

}  // namespace riffle::inline case_file
