#include <cmath>

#include "case/flow_kind.hpp"
#include "case/outline.hpp"
#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"

namespace riffle {

namespace {

double total(const Case& c, double depth) { return depth + c.datum(); }

/// Total depth of critical flow with a discharge, m.
double critical_depth(const Case& c, double unit_discharge) {
    return std::cbrt(unit_discharge * unit_discharge / c.normal_gravity());
}

int ways_to_give_discharge(const Inflow& inflow) {
    return (inflow.discharge ? 1 : 0) + (inflow.unit_discharge ? 1 : 0) +
           (inflow.discharge_file.empty() ? 0 : 1);
}

/// Whether something of a solid stands within a distance of either end.
Findings too_near(const Case& c, const Solid& solid) {
    const double clear = open_end_clearance(c);
    for (const double x : solid.x) {
        if (x < clear || x > c.channel.length - clear) {
            return found_if(true, "it reaches to x = {}, the channel from 0 to {}", shown_length(x),
                            shown_length(c.channel.length));
        }
    }
    return {};
}

/// Ends at which the outline of the water begins above the bed.
Findings floating_ends(const Case& c) {
    const Outline water{c.start.water_x, c.start.water_z};
    for (const double end : {0.0, c.channel.length}) {
        const double x = within_ends(end, c.channel.length);
        const double lowest = is_simple(water) ? ceiling_above(water, x, 0.0) : 0.0;
        if (lowest > 0.0 && !contains(water, x, 0.5 * lowest)) {
            return found_if(true, "the water at x = {} begins at a height of {}", shown_length(end),
                            shown_length(lowest));
        }
    }
    return {};
}

}  // namespace

CheckList open_end_refusals() {
    return {
        {
            {{"inflow.discharge", "inflow.depth"},
             "neither a discharge nor a depth at the inflow",
             "open ends need to know what enters",
             "give [inflow] discharge = \"8 l/s\", for example, or unit_discharge, discharge_file or depth",
             [](const Case& c) {
                 return found_if(!c.inflow.gives_discharge() && !c.inflow.gives_depth(),
                                 "[inflow] gives neither a discharge nor a depth");
             }},
            {{"inflow.discharge", "inflow.unit_discharge", "inflow.discharge_file"},
             "the discharge given twice",
             "only one can hold",
             "keep one of discharge, unit_discharge and discharge_file",
             [](const Case& c) {
                 return found_if(ways_to_give_discharge(c.inflow) > 1,
                                 "[inflow] gives the discharge in {} ways", ways_to_give_discharge(c.inflow));
             }},
            {{"inflow.depth", "inflow.depth_file"},
             "the depth at the inflow given twice",
             "only one can hold",
             "keep one of depth and depth_file",
             [](const Case& c) { return c.inflow.depth && !c.inflow.depth_file.empty(); }},
            {{"inflow.depth", "inflow.discharge"},
             "both discharge and depth of a subcritical inflow",
             "subcritical flow takes one of them from downstream",
             "remove one of them; the other follows",
             [](const Case& c) {
                 const auto q = c.inflow_unit_discharge();
                 if (!q || !c.inflow.depth) {
                     return Findings{};
                 }
                 const double critical = critical_depth(c, *q);
                 return found_if(total(c, *c.inflow.depth) > critical,
                                 "the depth of {} is above the critical one of the discharge, {}",
                                 shown_length(*c.inflow.depth), shown_length(critical - c.datum()));
             }},
            {{"inflow.equivalent_roughness", "inflow.profile"},
             "`equivalent_roughness` 0 with `profile = \"log-law\"`",
             "the log law needs k_s",
             "give it",
             [](const Case& c) {
                 return c.inflow.profile == InflowProfile::log_law && c.inflow.equivalent_roughness <= 0.0;
             }},
            {{"inflow.profile_file", "inflow.profile"},
             "`profile_file` missing with `profile = \"file\"`",
             "",
             "give the CSV file with the columns z, u",
             [](const Case& c) {
                 return found_if(c.inflow.profile == InflowProfile::file && c.inflow.profile_file.empty(),
                                 "profile_file is missing");
             }},
            {{"inflow.profile", "bed.kind"},
             "`profile = \"column\"` over a bed without friction",
             "no profile is the twin's own there",
             "choose profile = \"uniform\", or another",
             [](const Case& c) { return c.inflow.profile == InflowProfile::column && !bed_resists(c.bed); }},
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
                 if (!q || c.outflow.kind != OutflowKind::depth || !c.outflow.depth) {
                     return Findings{};
                 }
                 const double critical = critical_depth(c, *q);
                 return found_if(total(c, *c.outflow.depth) < critical,
                                 "depth is {}, the critical depth of the discharge {}",
                                 shown_length(*c.outflow.depth), shown_length(critical - c.datum()));
             }},
            {{"outflow.kind", "channel.slope"},
             "`kind = \"normal-depth\"` where no flow is uniform",
             "a bed that does not fall, or without friction, has no normal depth",
             "choose kind = \"depth\" or another",
             [](const Case& c) {
                 return found_if(c.outflow.kind == OutflowKind::normal_depth &&
                                     (!(c.streamwise_gravity() > 0.0) || !bed_resists(c.bed)),
                                 "kind = \"normal-depth\" needs a slope and a bed with friction");
             }},
            {{"outflow.kind", "inflow.discharge_file"},
             "`kind = \"normal-depth\"` without a constant discharge",
             "the normal depth is found once, for one discharge",
             "give the discharge or unit_discharge, or choose kind = \"rating-curve\"",
             [](const Case& c) {
                 return found_if(c.outflow.kind == OutflowKind::normal_depth && !c.inflow_unit_discharge(),
                                 "kind = \"normal-depth\" needs a constant discharge");
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
                                 "weir_height is missing");
             }},
            lost_file("inflow.discharge_file", "a `discharge_file` that is not there",
                      [](const Case& c) { return is_lost(c, c.inflow.discharge_file); }),
            lost_file("inflow.depth_file", "a `depth_file` of the inflow that is not there",
                      [](const Case& c) { return is_lost(c, c.inflow.depth_file); }),
            lost_file("inflow.profile_file", "a `profile_file` that is not there",
                      [](const Case& c) { return is_lost(c, c.inflow.profile_file); }),
            lost_file("outflow.depth_file", "a `depth_file` of the outflow that is not there",
                      [](const Case& c) { return is_lost(c, c.outflow.depth_file); }),
            lost_file("outflow.rating_file", "a `rating_file` that is not there",
                      [](const Case& c) { return is_lost(c, c.outflow.rating_file); }),
            {{"channel.length", "numerics.spacing"},
             "`length` too short for open ends",
             "the water is watched over two kernel supports beside either end",
             "make the channel longer or the spacing smaller",
             [](const Case& c) {
                 return found_if(c.channel.length < 4.0 * kernel_support(c),
                                 "length is {}: open ends need at least {}", shown_length(c.channel.length),
                                 shown_length(4.0 * kernel_support(c)));
             }},
            {{"channel.top"},
             "`top` other than `\"free-surface\"` with open ends",
             "the depth at an open end is that of a free surface",
             "set [channel] top = \"free-surface\"",
             [](const Case& c) { return !has_free_surface(c); }},
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
             "a `kind` of start other than column, uniform, rest, power-law or backwater with open ends",
             "the others are flows without ends",
             R"(choose kind = "column" or "backwater")",
             [](const Case& c) {
                 const StartKind kind = c.start.kind;
                 return kind == StartKind::standing_wave || kind == StartKind::taylor_green ||
                        kind == StartKind::section || kind == StartKind::results;
             }},
            {{"start.kind", "inflow.discharge"},
             "`kind = \"backwater\"` without a constant discharge",
             "varied flow is steady",
             "give [inflow] discharge, or start otherwise",
             [](const Case& c) {
                 return found_if(c.start.kind == StartKind::backwater && !c.inflow_unit_discharge(),
                                 "kind = \"backwater\" needs a constant discharge");
             }},
            {{"start.water_z", "channel.ends"},
             "water at an open end that does not stand on the bed",
             "what is beyond the end is as deep as the water beside it",
             "draw its outline down to z = 0 there, or away from the end",
             floating_ends},
            {{"solid.x", "channel.ends"},
             "a solid in the water that enters or leaves",
             "the water is watched over two kernel supports beside either end",
             "move the solid, or make the channel longer",
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

}  // namespace riffle
