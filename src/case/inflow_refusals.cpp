#include <algorithm>
#include <optional>

#include "case/bed_patch.hpp"
#include "case/bed_traits.hpp"
#include "case/cross_section.hpp"
#include "case/end_buffers.hpp"
#include "case/end_floor.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

int ways_to_give_discharge(const Inflow& inflow) {
    return (inflow.discharge ? 1 : 0) + (inflow.unit_discharge ? 1 : 0) +
           (inflow.discharge_file.empty() ? 0 : 1);
}

/// Whether the profile that enters is one of the twins'.
bool enters_as_twin(const Case& c) {
    return c.inflow.profile == InflowProfile::twin || c.inflow.profile == InflowProfile::column;
}

}  // namespace

CheckList inflow_refusals() {
    return {
        {
            {{"inflow.discharge", "inflow.depth"},
             "neither a discharge nor a depth at the inflow",
             "open ends need to know what enters",
             "give [inflow] discharge = \"8 l/s\", for example, or unit_discharge, discharge_file or depth",
             [](const Case& c) {
                 return found_if(!c.inflow.gives_discharge() && !c.inflow.gives_depth(),
                                 "gives neither a discharge nor a depth");
             }},
            {{"inflow.discharge", "inflow.unit_discharge", "inflow.discharge_file"},
             "the discharge given twice",
             "only one can hold",
             "keep one of discharge, unit_discharge and discharge_file",
             [](const Case& c) {
                 return found_if(ways_to_give_discharge(c.inflow) > 1, "gives the discharge in {} ways",
                                 ways_to_give_discharge(c.inflow));
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
                 // Over measured heights the ends themselves look at it.
                 if (!q || !c.inflow.depth || measured_bed_of(c) != nullptr) {
                     return Findings{};
                 }
                 const double critical = critical_depth_of(c, *q);
                 return found_if(over_floor(c, *c.inflow.depth, end_floors(c).upstream) > critical,
                                 "the depth of {} is above the critical one of the discharge, {}",
                                 shown_length(*c.inflow.depth),
                                 shown_length(critical + end_floors(c).upstream - c.datum()));
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
            {{"inflow.results", "inflow.profile"},
             "`results` missing with `profile = \"results\"`",
             "the water of another run enters",
             "give the results file of a run with periodic ends, for example results = \"reach/results.h5\"",
             [](const Case& c) {
                 return found_if(c.inflow.profile == InflowProfile::results && c.inflow.results.empty(),
                                 "results is missing");
             }},
            {{"inflow.profile", "bed.kind"},
             R"(`profile = "twin"`, the default, or `"column"` over a bed without friction, the former without friction of side walls too)",
             "no profile is the twin's own there",
             "choose profile = \"uniform\", or another",
             [](const Case& c) {
                 const bool column = c.inflow.profile == InflowProfile::column;
                 const Case there = with_bed_at(c, 0.0);
                 return enters_as_twin(c) &&
                        !(column ? channel_resists(there) : channel_or_walls_resist(there));
             }},
            {{"inflow.profile", "turbulence.closure"},
             R"(`profile = "twin"`, the default, or `"column"` with a closure of resolved eddies)",
             "it has no twin, and water without eddies would enter",
             R"(choose profile = "results", the water of a run with periodic ends, or for a start of their growth "power-law")",
             [](const Case& c) { return enters_as_twin(c) && channel_resists(c) && resolves_eddies(c); }},
            {{"inflow.profile", "bed_patch.y_from"},
             R"(`profile = "twin"`, the default, or `"column"` where a patch of the bed lies in a part of the inflow's width; with `"twin"` strips of plane beds may lie between side walls, the same on both sides of the centreline)",
             "what enters there has the profile of one bed",
             "choose profile = \"log-law\" or another, or let the patch begin farther down",
             [](const Case& c) {
                 const BedPatch* const beside = patch_beside(c, 0.0);
                 const bool has_twin =
                     c.inflow.profile == InflowProfile::twin && beside && strips_have_section(c, 0.0);
                 return found_if(beside != nullptr && enters_as_twin(c) && !has_twin,
                                 "profile is that of a twin, and the patch \"{}\" lies there",
                                 beside ? beside->name : std::string());
             }},
            {{"inflow.depth", "channel.top"},
             "no discharge, or a depth, at the inflow of a duct",
             "a duct is always full",
             "give [inflow] discharge, unit_discharge or discharge_file, and no depth",
             [](const Case& c) {
                 return is_duct(c) && (c.inflow.gives_depth() || !c.inflow.gives_discharge());
             }},
            {{"inflow.depth", "solid.z"},
             "a depth at the inflow below the top of the solid there",
             "no water would enter",
             "make it deeper: it counts from the zero datum, like channel.depth",
             [](const Case& c) { return below_floor(c.inflow.depth, c, end_floors(c).upstream); }},
            {{"inflow.profile", "solid.z"},
             R"(`profile = "twin"`, the default, or `"column"` over a solid at the inflow, unless `bed.kind = "no-slip"`)",
             "the twin's profile is that over the bed",
             "choose profile = \"uniform\", or another",
             [](const Case& c) {
                 return end_floors(c).upstream > 0.0 && enters_as_twin(c) && !is_no_slip(c.bed);
             }},
        },
        [](const Case& c) { return c.channel.ends == Ends::open; }};
}

}  // namespace riffle::inline case_file
