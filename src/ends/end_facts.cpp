#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "case/cross_section.hpp"
#include "case/end_buffers.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/units.hpp"
#include "ends/flow_at_ends.hpp"

namespace riffle::inline ends {

namespace {

/// A value with four significant digits, or the range of a quantity that changes.
std::string range_text(const Extremes& range, const char* unit) {
    const std::string least = fmt::format("{:.4g}", range.least);
    const std::string largest = fmt::format("{:.4g}", range.largest);
    return (least == largest ? least : least + " to " + largest) + unit;
}

std::string millimetres(const Extremes& range) {
    return range_text({1e3 * range.least, 1e3 * range.largest}, " mm");
}

/// Near enough to 1 to be called critical: closer than a run tells, and than the critical depth of a uniform
/// velocity, which an outflow holds, is to that of a profile.
constexpr double critical_band = 3e-2;

const char* regime(double froude) {
    return std::abs(froude - 1.0) < critical_band ? "critical"
           : froude < 1.0                         ? "subcritical"
                                                  : "supercritical";
}

std::string regime_text(const Extremes& froude) {
    const std::string slow = regime(froude.least);
    const std::string fast = regime(froude.largest);
    return slow == fast ? slow : slow + " to " + fast;
}

/// "U = ..., Fr = ..., subcritical"; empty where the flow there is not known.
std::string motion_text(const FlowAtEnd& end) {
    std::string text;
    if (end.velocity) text += "U = " + range_text(*end.velocity, " m/s");
    if (end.froude) text += ", Fr = " + range_text(*end.froude, "") + ", " + regime_text(*end.froude);
    return text;
}

/// A depth, also over the solid that the water stands on there.
std::string depth_text(const Extremes& depth, double floor) {
    return floor > 0.0 ? fmt::format("{} ({} over the solid there)", millimetres(depth),
                                     millimetres({depth.least - floor, depth.largest - floor}))
                       : millimetres(depth);
}

std::string discharge_text(const Case& c, const FlowAtEnds& states) {
    std::string text = "q = " + range_text(states.unit_discharge, " m2/s");
    if (c.channel.dimensions == 3 || c.inflow.discharge) {
        const double litres = 1e3 * c.channel.width;
        text += fmt::format(
            " ({} over the width of {})",
            range_text({litres * states.unit_discharge.least, litres * states.unit_discharge.largest},
                       " l/s"),
            shown_length(c.channel.width));
    }
    if (!c.inflow.discharge_file.empty()) text += " by " + c.inflow.discharge_file.filename().string();
    return text + (states.gives_discharge ? "" : " at the start, and follows from the depths");
}

std::string inflow_text(const Case& c, const FlowAtEnds& states) {
    const FlowAtEnd& end = states.inflow;
    std::string text = discharge_text(c, states);
    if (end.depth) {
        const std::string depth = depth_text(*end.depth, end.floor);
        switch (end.source) {
            case DepthSource::given:
                text += ", depth " + depth;
                if (!c.inflow.depth_file.empty()) text += " by " + c.inflow.depth_file.filename().string();
                break;
            case DepthSource::backwater:
                text += ", depth " + depth + " by riffle backwater";
                break;
            case DepthSource::uniform:
                text += ", depth " + depth + " of uniform flow (the flow sets it)";
                break;
            case DepthSource::steady:
                text += ", depth " + depth + " of steady flow with each discharge (the flow sets it)";
                break;
            case DepthSource::start:
                text += ", depth " + depth + " at the start (the flow sets it)";
                break;
            case DepthSource::full:
                text += fmt::format(", {} high", millimetres(*end.depth));
                break;
            case DepthSource::unknown:
                break;
        }
    }
    const std::string motion = motion_text(end);
    text += motion.empty() ? "" : ", " + motion;
    // Nothing from downstream tells a supercritical inflow its depth.
    if (!c.inflow.gives_depth() && end.froude && end.froude->largest > 1.0 + critical_band) {
        text += fmt::format(
            ". Without [inflow] depth the water enters at the critical depth and shoots off from there: give the depth with "
            "which it enters{}",
            end.depth && !end.depth->changes() ? ", " + millimetres(*end.depth) : std::string());
    }
    return text;
}

/// Where the outflow takes longer to bring the depth of the start to the one that it holds than the run
/// lasts: the default lets waves out.
std::string holding_text(const Case& c, const FlowAtEnds& states) {
    if (!states.held_depth) return "";
    if (states.held_depth->changes()) {
        const char* const following =
            tailwater_changes(c) ? "a change by the file is followed at once, any other departure goes"
                                 : "it follows that";
        return fmt::format("; {} in some {:.3g} s (outflow.relaxation_time)", following, states.holding_time);
    }
    if (c.outflow.relaxation_time || c.run.until != RunUntil::time) return "";
    constexpr double enough = 2.0;  // times e
    if (c.run.time >= enough * states.holding_time) return "";
    constexpr double same = 1e-3;
    const Extremes held = *states.held_depth;
    const double start = c.start.kind == StartKind::backwater ? held.least : c.channel.depth;
    if (std::max(std::abs(held.largest - start), std::abs(held.least - start)) <= same * start) return "";
    return fmt::format(
        "; the depth goes there in some {:.3g} s, and the run ends after {:.3g} s: give a shorter "
        "outflow.relaxation_time, or run longer",
        states.holding_time, c.run.time);
}

/// What rules the water that leaves.
std::string held_text(const Case& c, const FlowAtEnds& states) {
    const std::string depth =
        states.held_depth ? depth_text(*states.held_depth, states.outflow.floor) : std::string();
    switch (c.outflow.kind) {
        case OutflowKind::depth:
            return "holds " + depth +
                   (c.outflow.depth_file.empty() ? "" : " by " + c.outflow.depth_file.filename().string());
        case OutflowKind::normal_depth:
            return "holds the normal depth, " + depth;
        case OutflowKind::critical_depth:
            return "holds the critical depth, " + depth;
        case OutflowKind::weir:
            return fmt::format("holds {}, the head over a crest of {}", depth,
                               shown_length(c.outflow.weir_height));
        case OutflowKind::rating_curve:
            return fmt::format("holds {}, by {} at this discharge", depth,
                               c.outflow.rating_file.filename().string());
        case OutflowKind::free:
            return "holds nothing: fast water leaves as it comes, slower water at the critical depth";
        case OutflowKind::free_fall:
            return "holds nothing: the bed ends, and the flow is critical three to four depths before";
        case OutflowKind::pressure:
            break;
    }
    return "holds the pressure";
}

std::string outflow_text(const Case& c, const FlowAtEnds& states) {
    const FlowAtEnd& end = states.outflow;
    std::string text = held_text(c, states);
    // What the outflow holds need not be what the flow has there.
    constexpr double same = 1e-3;
    const bool leaves_otherwise =
        end.source == DepthSource::backwater && c.outflow.kind != OutflowKind::free_fall &&
        (!states.held_depth ||
         std::abs(end.depth->least - states.held_depth->least) > same * states.held_depth->least);
    if (leaves_otherwise) {
        text += "; by riffle backwater it is " + millimetres(*end.depth) + " deep";
    }
    const std::string motion = motion_text(end);
    return text + (motion.empty() || c.outflow.kind == OutflowKind::free_fall ? "" : ", " + motion) +
           holding_text(c, states);
}

/// What the file of a profile leaves open, where that is more than a row of particles; else empty.
std::string profile_text(const Case& c, const FlowAtEnds& states) {
    const Extremes& given = *states.profile_heights;
    // Over the datum; a profile stretches with the depth of the water, and is given for that of the case.
    const double bottom = states.inflow.floor > 0.0 ? states.inflow.floor : 0.0 - c.datum();
    const bool below = given.least > bottom + c.numerics.spacing;
    const bool above = given.largest < c.channel.depth - c.numerics.spacing;
    constexpr double wide = 0.25;  // of the depth
    const auto& gap = states.profile_gap;
    const std::string between =
        gap && gap->largest - gap->least > wide * c.channel.depth
            ? fmt::format("between {} and {} it has no point, and u goes straight from one to the other",
                          shown_length(gap->least), shown_length(gap->largest))
            : "";
    if (!below && !above) {
        return between.empty() ? ""
                               : fmt::format("{}: {}; add points where that is not meant",
                                             c.inflow.profile_file.filename().string(), between);
    }
    std::string text = fmt::format(
        "{} gives u from {} to {} over the datum alone:", c.inflow.profile_file.filename().string(),
        shown_length(given.least), shown_length(given.largest));
    if (below) {
        text += fmt::format(" its lowest u goes on down to {}, the bottom", shown_length(bottom));
    }
    if (above) {
        text += fmt::format("{} its highest up to {}, the surface", below ? "," : "",
                            shown_length(c.channel.depth));
    }
    return text + (between.empty() ? "" : "; " + between) + "; add points where that is not meant";
}

/// Critical and normal depth at an end, and what the slope is with them; empty without discharge.
std::string characteristic_text(const Case& c, const FlowAtEnd& end) {
    if (!end.critical_depth || !(end.critical_depth->largest > 0.0)) return "";
    const Extremes critical = *end.critical_depth;
    constexpr double noticed_slope = 0.045;  // 1 - cos θ = 1e-3
    const bool above_datum = end.floor == 0.0 && c.datum() > 0.0;
    const std::string law = c.channel.slope > noticed_slope ? "(q²/(g cos θ))^(1/3)" : "(q²/g)^(1/3)";
    std::string text = "critical depth ";
    const bool in_rectangle = uneven_bed_of(c) == nullptr;
    if (!end.critical_of_profile && in_rectangle) {
        text += law + (above_datum ? fmt::format(" less the {:.4g} mm up to the datum = ", 1e3 * c.datum())
                                   : " = ");
    }
    text += millimetres(critical);
    if (end.normal_depth) {
        const Extremes normal = *end.normal_depth;
        text += fmt::format(", normal depth {}", millimetres(normal));
        if (normal.least > critical.least && normal.largest > critical.largest) {
            text += " (a mild slope)";
        } else if (normal.least < critical.least && normal.largest < critical.largest) {
            text += " (a steep slope)";
        }
    }
    return text;
}

/// Where riffle backwater puts a hydraulic jump, or why there is none between the ends; else empty.
std::string jump_text(const FlowAtEnds& states) {
    if (!states.varied) return "";
    std::string text;
    if (const auto& jump = states.varied->jump) {
        text =
            fmt::format("a hydraulic jump at x = {:.3g} m, from {:.3g} to {:.3g} mm, Fr = {:.3g} before it",
                        jump->place, 1e3 * jump->depth_before, 1e3 * jump->depth_after, jump->froude_before);
    }
    for (const std::string& event : states.varied->events) {
        text += (text.empty() ? "" : ". ") + event.substr(0, event.find_last_not_of('.') + 1);
    }
    return text;
}

/// Where the water rises so high over the depth of the case that the stretch over which it is watched is a
/// small share of it: the ends then feed its swings.
std::string watched_text(const Case& c, const FlowAtEnds& states) {
    if (is_duct(c)) return "";
    double highest = c.channel.depth;
    if (states.inflow.depth) highest = std::max(highest, states.inflow.depth->largest);
    if (states.held_depth) highest = std::max(highest, states.held_depth->largest);
    const double share = watched_stretch(c) / (highest + c.datum());
    constexpr double steady_share = 0.15;  // from which on no swing grew (docs/theory.md 20)
    if (share >= steady_share) return "";
    return fmt::format(
        "over {} beside each end, {:.2g} of the highest water, {}: below {:.2g} the discharge may swing; give "
        "[channel] depth at least {}, and the water of the start by start.water_x and start.water_z",
        shown_length(watched_stretch(c)), share, shown_length(highest), steady_share,
        shown_length(steady_share / least_watched_share * (highest + c.datum()) - c.datum()));
}

}  // namespace

std::vector<EndFact> end_facts(const Case& c, const FlowAtEnds& states) {
    std::vector<EndFact> facts{{"inflow", inflow_text(c, states)}, {"outflow", outflow_text(c, states)}};
    if (const std::string profile = states.profile_heights ? profile_text(c, states) : ""; !profile.empty()) {
        facts.push_back({"profile of the inflow", profile});
    }
    const std::string at_inflow = characteristic_text(c, states.inflow);
    const std::string at_outflow = characteristic_text(c, states.outflow);
    if (!at_inflow.empty() && (states.one_bed || at_inflow == at_outflow)) {
        facts.push_back({"of this discharge", at_inflow});
    } else if (!at_inflow.empty()) {
        facts.push_back({"of it at the inflow", at_inflow});
        facts.push_back({"of it at the outflow", at_outflow});
    }
    if (const std::string jump = jump_text(states); !jump.empty()) {
        facts.push_back({"riffle backwater", jump});
    }
    if (const std::string watched = watched_text(c, states); !watched.empty()) {
        facts.push_back({"watched", watched});
    }
    if (states.reynolds) {
        facts.push_back(
            {"Reynolds number", fmt::format("{:.4g} of U and twice the height", *states.reynolds)});
    }
    return facts;
}

}  // namespace riffle::inline ends
