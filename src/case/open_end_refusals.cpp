#include <algorithm>
#include <optional>

#include "case/bed_patch.hpp"
#include "case/cross_section.hpp"
#include "case/end_buffers.hpp"
#include "case/end_floor.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/outline.hpp"
#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/solid_shapes.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

/// Cross-sections and beds of heights.
bool is_bed_in_space(const Case& c, const Solid& solid) { return in_space(c) && is_bed_shape(solid.shape); }

/// Whether something of a solid stands within a distance of either end, unless it carries the water through.
Findings too_near(const Case& c, const Solid& solid) {
    const auto extent = extent_of(c, solid, 0);
    if (!extent || solid.is_free() || is_bed_in_space(c, solid)) {
        return {};
    }
    const double clear = watched_stretch(c);
    const double beyond = walls_beyond_end(c);
    const double length = c.channel.length;
    const bool carries = !in_space(c) && solid.rests();
    const auto blocks = [&](double from, double to) {
        return extent->low < to && extent->high > from && !(carries && carries_through(solid, from, to));
    };
    const bool upstream = blocks(-beyond, clear);
    if (!upstream && !blocks(length - clear, length + beyond)) {
        return {};
    }
    return found_if(
        true,
        "it reaches to x = {}, the channel from 0 to {}. One that carries the water through this end stands on the bed and has a level top at least from x = {} to x = {}",
        shown_length(upstream ? extent->low : extent->high), shown_length(length),
        shown_length(upstream ? -beyond : length - clear), shown_length(upstream ? clear : length + beyond));
}

/// Whether a free body starts where it would be held back.
Findings beyond_racks(const Case& c, const Solid& solid) {
    const auto extent = extent_of(c, solid, 0);
    if (!extent || !solid.is_free()) {
        return {};
    }
    const double clear = watched_stretch(c);
    const double length = c.channel.length;
    return found_if(extent->low < clear || extent->high > length - clear,
                    "it reaches from x = {} to {}, and the racks stand at {} and {}",
                    shown_length(extent->low), shown_length(extent->high), shown_length(clear),
                    shown_length(length - clear));
}

/// Ends at which the outline of the water begins above the bed.
Findings floating_ends(const Case& c) {
    const Outline water{c.start.water_x, c.start.water_z};
    for (const double end : {0.0, c.channel.length}) {
        const double x = within_ends(end, c.channel.length);
        const double floor = floor_at(c, x);
        const double lowest = is_simple(water) ? ceiling_above(water, x, floor) : floor;
        if (lowest > floor && !contains(water, x, 0.5 * (floor + lowest))) {
            return found_if(true, "the water at x = {} begins at a height of {}", shown_length(end),
                            shown_length(lowest));
        }
    }
    return {};
}

}  // namespace

Findings below_floor(const std::optional<double>& level, const Case& c, double floor) {
    return found_if(level && over_floor(c, *level, floor) <= 0.0,
                    "the depth of {} is below the top of the solid there, {} over the datum",
                    shown_length(level.value_or(0.0)), shown_length(floor - c.datum()));
}

CheckList open_end_refusals() {
    return {
        {
            {{"outflow.kind", "bed_patch.y_from"},
             "`kind = \"normal-depth\"`, the default, where a patch of the bed lies in a part of the outflow's width, but strips of plane beds between side walls, the same on both sides of the centreline",
             "no twin tells the normal depth over such a bed",
             "choose kind = \"depth\" or another, or let the patch end farther up",
             [](const Case& c) {
                 const BedPatch* const beside = patch_beside(c, c.channel.length);
                 const bool has_twin = beside && strips_have_section(c, c.channel.length);
                 return found_if(
                     beside != nullptr && c.outflow.kind == OutflowKind::normal_depth && !has_twin,
                     R"(kind is "normal-depth", and the patch "{}" lies there)",
                     beside ? beside->name : std::string());
             }},
            {{"outflow.depth", "outflow.kind"},
             "`kind = \"depth\"` without a depth",
             "",
             "give [outflow] depth or depth_file, or another kind",
             [](const Case& c) {
                 return found_if(
                     c.outflow.kind == OutflowKind::depth && !c.outflow.depth && c.outflow.depth_file.empty(),
                     "depth is missing");
             }},
            {{"outflow.depth", "outflow.depth_file"},
             "the depth at the outflow given twice",
             "only one can hold",
             "keep one of depth and depth_file",
             [](const Case& c) { return c.outflow.depth && !c.outflow.depth_file.empty(); }},
            {{"outflow.depth"},
             "a depth at the outflow below the critical one",
             "water leaves at the critical depth where nothing holds it back",
             R"(make it deeper, or choose kind = "critical-depth" or, for supercritical flow, "free")",
             [](const Case& c) {
                 const auto q = c.inflow_unit_discharge();
                 if (!q || c.outflow.kind != OutflowKind::depth || !c.outflow.depth ||
                     measured_bed_of(c) != nullptr) {
                     return Findings{};
                 }
                 const double critical = critical_depth_of(c, *q);
                 return found_if(over_floor(c, *c.outflow.depth, end_floors(c).downstream) < critical,
                                 "depth is {}, the critical depth of the discharge {}",
                                 shown_length(*c.outflow.depth),
                                 shown_length(critical + end_floors(c).downstream - c.datum()));
             }},
            {{"outflow.kind", "channel.slope"},
             "`kind = \"normal-depth\"` where no flow is uniform",
             "a bed that does not fall, or without friction, has no normal depth",
             "choose kind = \"depth\" or another",
             [](const Case& c) {
                 return found_if(c.outflow.kind == OutflowKind::normal_depth &&
                                     (!(c.streamwise_gravity() > 0.0) ||
                                      !channel_or_walls_resist(with_bed_at(c, c.channel.length))),
                                 "kind = \"normal-depth\" needs a slope and a bed with friction");
             }},
            {{"outflow.kind", "turbulence.closure"},
             "`kind = \"normal-depth\"`, the default, with a closure of resolved eddies",
             "no twin tells the normal depth of such a flow",
             "choose kind = \"depth\", with that of a run with periodic ends, or another",
             [](const Case& c) { return c.outflow.kind == OutflowKind::normal_depth && resolves_eddies(c); }},
            {{"outflow.kind", "inflow.unit_discharge", "inflow.discharge"},
             "`kind = \"normal-depth\"` with a discharge of nothing",
             "no water flows so",
             "give the discharge that enters, or choose another kind",
             [](const Case& c) {
                 const auto q = c.inflow_unit_discharge();
                 return found_if(c.outflow.kind == OutflowKind::normal_depth && q && !(*q > 0.0),
                                 "kind = \"normal-depth\" needs a discharge of more than nothing");
             }},
            {{"channel.depth", "inflow.unit_discharge"},
             "a discharge whose critical depth is more than twice the depth of the case",
             "the depth of the case sets how high the water may stand",
             "give a depth near that of the flow, or [inflow] depth with the supercritical one at which it enters",
             [](const Case& c) {
                 const auto q = c.inflow_unit_discharge();
                 if (!q || c.inflow.depth || !c.inflow.depth_file.empty() || is_duct(c)) {
                     return Findings{};
                 }
                 const double critical = critical_depth_of(c, *q);
                 return found_if(critical > 2.0 * c.total_depth(),
                                 "depth is {}, the critical depth of the discharge {}",
                                 shown_length(c.channel.depth), shown_length(critical - c.datum()));
             }},
            {{"run.until", "inflow.discharge_file"},
             "`until = \"converged\"` with a discharge or depth at an end that changes in time",
             "the flow does not become steady",
             "give a time, for example until = \"10 s\"",
             [](const Case& c) {
                 const char* const file = !c.inflow.discharge_file.empty() ? "[inflow] discharge_file"
                                          : !c.inflow.depth_file.empty()   ? "[inflow] depth_file"
                                                                           : "[outflow] depth_file";
                 return found_if(c.run.until == RunUntil::converged && changes_at_ends(c),
                                 "until is \"converged\", and {} changes in time", file);
             }},
            {{"outflow.rating_file", "outflow.kind"},
             "`kind = \"rating-curve\"` without `rating_file`",
             "",
             "give the CSV file with the columns depth, discharge",
             [](const Case& c) {
                 return found_if(c.outflow.kind == OutflowKind::rating_curve && c.outflow.rating_file.empty(),
                                 "rating_file is missing");
             }},
            {{"outflow.weir_height", "outflow.kind"},
             "`kind = \"weir\"` without `weir_height`",
             "",
             "give the height of its crest over the zero datum",
             [](const Case& c) {
                 return found_if(c.outflow.kind == OutflowKind::weir && c.outflow.weir_height <= 0.0,
                                 "weir_height is missing or 0");
             }},
            lost_file("inflow.discharge_file", "a `discharge_file` that is not there",
                      [](const Case& c) { return is_lost(c, c.inflow.discharge_file); }),
            lost_file("inflow.depth_file", "a `depth_file` of the inflow that is not there",
                      [](const Case& c) { return is_lost(c, c.inflow.depth_file); }),
            lost_file("inflow.profile_file", "a `profile_file` that is not there",
                      [](const Case& c) { return is_lost(c, c.inflow.profile_file); }),
            lost_results("inflow.results", "a `results` file of the inflow that is not there",
                         [](const Case& c) { return is_lost(c, c.inflow.results); }),
            lost_file("outflow.depth_file", "a `depth_file` of the outflow that is not there",
                      [](const Case& c) { return is_lost(c, c.outflow.depth_file); }),
            lost_file("outflow.rating_file", "a `rating_file` that is not there",
                      [](const Case& c) { return is_lost(c, c.outflow.rating_file); }),
            {{"channel.length", "numerics.spacing"},
             "`length` too short for open ends",
             "beside either end the water is watched over two kernel supports or a quarter of the depth, whichever is longer",
             "make the channel longer or the spacing smaller",
             [](const Case& c) {
                 return found_if(c.channel.length < 2.0 * watched_stretch(c),
                                 "length is {}: open ends need at least {}", shown_length(c.channel.length),
                                 shown_length(2.0 * watched_stretch(c)));
             }},
            {{"channel.top"},
             "`top = \"periodic\"` with open ends",
             "water that enters stands on a bed",
             R"(set [channel] top = "free-surface", or "wall" for a duct)",
             [](const Case& c) { return c.channel.top == Top::periodic; }},
            {{"outflow.kind", "channel.top"},
             "`kind = \"pressure\"` under a free surface, or another kind in a duct",
             "a depth rules where there is a surface, a pressure where there is none",
             R"(choose kind = "pressure" with [channel] top = "wall", and another kind with "free-surface")",
             [](const Case& c) { return is_duct(c) != (c.outflow.kind == OutflowKind::pressure); }},
            {{"channel.lid_velocity", "channel.ends"},
             "a lid that moves, with open ends",
             "what enters does not know of it",
             "set lid_velocity = 0",
             [](const Case& c) { return c.channel.lid_velocity != 0.0; }},
            {{"outflow.depth", "solid.z"},
             "a depth at the outflow below the top of the solid there",
             "no water would leave",
             "make it deeper: it counts from the zero datum, like channel.depth",
             [](const Case& c) { return below_floor(c.outflow.depth, c, end_floors(c).downstream); }},
            {{"channel.depth", "solid.z"},
             "a depth of the channel below the top of a solid that reaches through an end",
             "no water would be there",
             "make it deeper: it counts from the zero datum",
             [](const Case& c) {
                 const EndFloors floors = end_floors(c);
                 return below_floor(c.channel.depth, c, std::max(floors.upstream, floors.downstream));
             }},
            {{"outflow.kind", "solid.z"},
             R"(`kind = "normal-depth"` or `"free-fall"` over a solid at the outflow)",
             "they are those of the bed",
             "choose kind = \"depth\" or another",
             [](const Case& c) {
                 return end_floors(c).downstream > 0.0 && (c.outflow.kind == OutflowKind::normal_depth ||
                                                           c.outflow.kind == OutflowKind::free_fall);
             }},
            {{"start.kind", "solid.z"},
             "`kind = \"backwater\"` over a solid that reaches through an end, or in a duct",
             "riffle backwater knows the bed alone, and its surface",
             "start otherwise",
             [](const Case& c) {
                 const EndFloors floors = end_floors(c);
                 return c.start.kind == StartKind::backwater &&
                        (is_duct(c) || floors.upstream > 0.0 || floors.downstream > 0.0);
             }},
            {{"numerics.stepping"},
             R"(`stepping` other than `"leapfrog"` or `"semi-implicit-euler"` with open ends)",
             "the other methods move particles by rates, which those of an open end do not have",
             "choose stepping = \"leapfrog\"",
             [](const Case& c) {
                 return c.numerics.stepping != Stepping::leapfrog &&
                        c.numerics.stepping != Stepping::semi_implicit_euler;
             }},
            {{"numerics.wall"},
             "`wall` other than `\"dummy\"` with open ends",
             "the other walls have a state of their own, which would have to enter and leave too",
             "choose wall = \"dummy\"",
             [](const Case& c) { return c.numerics.wall != WallKind::dummy; }},
            {{"numerics.xsph"},
             "`xsph` above 0 with open ends",
             "the water that enters would move otherwise than its discharge",
             "set xsph = 0",
             [](const Case& c) { return c.numerics.xsph > 0.0; }},
            {{"start.lattice"},
             "`lattice` other than `\"square\"` with open ends",
             "water enters in rows above each other",
             "choose lattice = \"square\"",
             [](const Case& c) { return c.start.lattice != StartLattice::square; }},
            {{"start.kind"},
             "a `kind` of start other than column, uniform, rest, power-law, backwater or results with open ends",
             "the others are flows without ends",
             R"(choose kind = "column" or "backwater")",
             [](const Case& c) {
                 const StartKind kind = c.start.kind;
                 return kind == StartKind::standing_wave || kind == StartKind::taylor_green ||
                        kind == StartKind::isotropic || kind == StartKind::section;
             }},
            {{"start.kind", "inflow.discharge"},
             "`kind = \"backwater\"` without a discharge of more than nothing",
             "varied flow is that of a discharge",
             "give [inflow] discharge or discharge_file, whose first one it is, or start otherwise",
             [](const Case& c) {
                 return found_if(c.start.kind == StartKind::backwater && c.inflow.discharge_file.empty() &&
                                     !(c.inflow_unit_discharge().value_or(0.0) > 0.0),
                                 "kind = \"backwater\" needs a discharge of more than nothing");
             }},
            {{"start.water_z", "channel.ends"},
             "water at an open end that does not stand on the bed",
             "what is beyond the end is as deep as the water beside it",
             "draw its outline down to the bed there, or to the solid that carries it, or away from the end",
             floating_ends},
            {{"solid.motion", "solid.centre", "solid.x"},
             "a free body that starts before the rack of the inflow or behind that of the outflow",
             "free bodies are held back before either end by the stretch over which the water is watched there: two kernel supports or a quarter of the depth, whichever is longer",
             "move it, or make the channel longer",
             [](const Case& c, const Solid& solid) { return beyond_racks(c, solid); }},
            {{"solid.x", "channel.ends"},
             "a solid in the water that enters or leaves",
             "beside either end the water is watched over two kernel supports or a quarter of the depth, whichever is longer",
             "move the solid, make the channel longer, or let the solid carry the water through the end",
             [](const Case& c, const Solid& solid) { return too_near(c, solid); }},
        },
        [](const Case& c) { return c.channel.ends == Ends::open; }};
}

CheckList closed_end_refusals() {
    return {{
                {{"start.kind", "channel.ends"},
                 "`kind = \"backwater\"` without open ends",
                 "varied flow needs water that enters and leaves",
                 "set [channel] ends = \"open\"",
                 [](const Case& c) { return c.start.kind == StartKind::backwater; }},
            },
            [](const Case& c) { return c.channel.ends != Ends::open; }};
}

}  // namespace riffle::inline case_file
