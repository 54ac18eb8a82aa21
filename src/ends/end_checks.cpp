#include "ends/end_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/cross_section.hpp"
#include "case/end_levels.hpp"
#include "case/units.hpp"
#include "case/words.hpp"
#include "ends/end_lattice.hpp"
#include "laboratory/profile_record.hpp"

namespace riffle::inline ends {

namespace {

/// What holds the water at the outflow, and what to do where that is too low; empty of kinds that cannot be.
struct Holding {
    std::string what;
    const char* cure = "";
    bool by_file = false;
};

Holding holding_of(const Case& c) {
    const Outflow& outflow = c.outflow;
    switch (outflow.kind) {
        case OutflowKind::depth:
            if (outflow.depth_file.empty()) {
                // One depth with one discharge is refused with the case, but over measured heights.
                if (c.inflow.discharge_file.empty() && measured_bed_of(c) == nullptr) return {};
                return {"[outflow] depth: it", "make it deeper", false};
            }
            return {outflow.depth_file.string() + ": it", "make it deeper", true};
        case OutflowKind::rating_curve:
            return {outflow.rating_file.string() + ": the rating curve", "make it deeper", true};
        case OutflowKind::weir:
            return {"[outflow] kind = \"weir\": the weir",
                    "raise weir_height, or make weir_coefficient smaller", false};
        case OutflowKind::normal_depth:
        case OutflowKind::critical_depth:
        case OutflowKind::free:
        case OutflowKind::free_fall:
        case OutflowKind::pressure:
            break;
    }
    return {};
}

/// Times at which what tables say is looked at, s: of their rows and between two of them too, for a rating
/// curve has rows of its own, and the critical depth is no straight line.
std::vector<double> times_to_look_at(const Case& c, const EndInput& input) {
    std::vector<double> rows = times_of_tables(c, input);
    std::sort(rows.begin(), rows.end());
    constexpr int parts = 50;
    std::vector<double> times{rows.front()};
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        for (int part = 1; part <= parts; ++part) {
            times.push_back(rows[i] + (rows[i + 1] - rows[i]) * part / parts);
        }
    }
    return times;
}

/// The file that says how much water flows.
std::string source_of_discharge(const Case& c) {
    return c.inflow.discharge_file.empty() ? c.name() : c.inflow.discharge_file.string();
}

constexpr double nearly_critical = 1e-3;  // of the critical depth

}  // namespace

void require_supercritical_inflow(const Case& c, const EndInput& input, double floor) {
    // One depth with one discharge is refused with the case, but over measured heights.
    const bool by_file =
        !c.inflow.discharge_file.empty() || !c.inflow.depth_file.empty() || measured_bed_of(c) != nullptr;
    if (!by_file || !input.unit_discharge || !input.inflow_depth) return;
    const LongWaves waves = waves_of(c, true);
    for (const double time : times_to_look_at(c, input)) {
        const double depth = input.inflow_depth->at(time);
        const double discharge = input.unit_discharge->at(time);
        const double critical = waves.critical_depth(discharge);
        if (depth <= (1.0 + nearly_critical) * critical) continue;
        const auto level = [&](double over_floor) { return shown_length(over_floor + floor - c.datum()); };
        throw FileError(fmt::format(
            "{}: at t = {:.4g} s the depth of {} is above the critical one of the discharge of {:.4g} m2/s, {}: "
            "subcritical flow takes one of depth and discharge from downstream; remove one of them from [inflow], and "
            "the other follows, or give depths at which the water shoots at all times of the run",
            !c.inflow.depth_file.empty() ? c.inflow.depth_file.string() : source_of_discharge(c), time,
            level(depth), discharge, level(critical)));
    }
}

void require_profile_in_water(const Case& c, double floor) {
    if (c.inflow.profile != InflowProfile::file) return;
    const std::vector<double> heights = read_profile_record(c.inflow.profile_file).z;
    const double bottom = floor - c.datum();
    const auto inside = std::count_if(heights.begin(), heights.end(),
                                      [&](double z) { return z > bottom && z <= c.channel.depth; });
    const auto all = static_cast<std::ptrdiff_t>(heights.size());
    // A point at the bed alone tells of no unit.
    if (inside >= 2 || inside == all) return;
    const auto [least, largest] = std::minmax_element(heights.begin(), heights.end());
    throw FileError(fmt::format(
        "{}: {} of its {} heights, {} to {} over the datum, lie outside of the water, which reaches from {} to {}; "
        "say their unit in the heading, as in \"z [mm]\", or correct them",
        c.inflow.profile_file.string(), all - inside, all, shown_length(*least), shown_length(*largest),
        shown_length(bottom), shown_length(c.channel.depth)));
}

void require_subcritical_outflow(const Case& c, const EndInput& input, double floor) {
    const Holding holding = holding_of(c);
    if (holding.what.empty() || !input.unit_discharge || !input.outflow_depth) return;
    std::vector<double> times = times_to_look_at(c, input);
    const LongWaves waves = waves_of(c, false);
    const auto critical_at = [&](double time) {
        return waves.critical_depth(input.unit_discharge->at(time));
    };
    const auto held_at = [&](double time) {
        return input.outflow_depth(input.unit_discharge->at(time), time);
    };
    // Nothing is critical where nothing flows.
    std::erase_if(times, [&](double time) { return !(critical_at(time) > 0.0); });
    if (times.empty()) return;
    // Where it lacks most.
    const double worst = *std::min_element(times.begin(), times.end(), [&](double a, double b) {
        return held_at(a) * critical_at(b) < held_at(b) * critical_at(a);
    });
    if (held_at(worst) >= (1.0 - nearly_critical) * critical_at(worst)) return;
    const auto level = [&](double over_floor) { return shown_length(over_floor + floor - c.datum()); };
    const std::string message = fmt::format(
        "{} holds {} at the discharge of {:.4g} m2/s (t = {:.4g} s), whose critical depth is {}: water leaves at "
        "the critical depth where nothing holds it back; {}, or choose [outflow] kind = \"critical-depth\" or, "
        "for supercritical flow, \"free\"",
        holding.what, level(held_at(worst)), input.unit_discharge->at(worst), worst,
        level(critical_at(worst)), holding.cure);
    if (holding.by_file) throw FileError(message);
    throw InputError(fmt::format("{}: {}", source_of_discharge(c), message));
}

void require_room(const Case& c, const std::string& asking, const std::string& what, double level) {
    const double room = level_with_room(c);
    if (level > room) {
        throw FileError(fmt::format(
            "{}: {} {} over the bed; the channel has room for {}, four times its depth; give [channel] depth at "
            "least {}, and the water of the start by start.water_x and start.water_z where it is lower",
            asking, what, shown_length(level - c.datum()), shown_length(room - c.datum()),
            shown_length(level / room * std::max(c.total_depth(), highest_end_level(c)) - c.datum())));
    }
}

void require_room_for_rule(const Case& c, const EndInput& input, double floor) {
    if (!input.outflow_depth || !input.unit_discharge) return;
    double largest = 0.0;
    for (const double time : times_of_tables(c, input)) {
        largest = std::max(largest, input.unit_discharge->at(time));
    }
    require_room(
        c,
        c.outflow.kind == OutflowKind::rating_curve ? c.outflow.rating_file.string() : source_of_discharge(c),
        fmt::format("[outflow] kind = \"{}\" holds, at the largest discharge, {:.4g} m2/s,",
                    word(c.outflow.kind), largest),
        input.outflow_depth(largest, 0.0) + floor);
}

}  // namespace riffle::inline ends
