#include <algorithm>

#include "case/cross_section.hpp"
#include "case/flow_kind.hpp"
#include "case/packed_start.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

bool starts_as(const Case& c, StartKind kind) { return c.start.kind == kind; }

}  // namespace

CheckList start_refusals() {
    return {{
        {{"turbulence.zero"},
         "`zero` at the surface or above",
         "no height would have a mixing length",
         "make it smaller",
         [](const Case& c) {
             return found_if(c.turbulence.zero >= c.total_depth(), "zero is {}, not below the surface at {}",
                             shown_length(c.turbulence.zero), shown_length(c.total_depth()));
         }},
        {{"start.kind"},
         "`kind = \"column\"` in a case without a column twin: one without a steady uniform flow",
         "",
         R"(or choose kind = "rest", "uniform" or "power-law")",
         [](const Case& c) {
             const auto reason = why_no_column(c);
             return found_if(starts_as(c, StartKind::column) && c.channel.ends != Ends::open && reason,
                             "kind = \"column\" starts from the column twin, and the case has none: {}",
                             reason.value_or(""));
         }},
        {{"start.velocity", "start.kind"},
         R"(`velocity` missing with `kind = "uniform"` or `"power-law"` in a case without a column twin)",
         "",
         "or give the velocity, for example velocity = \"0.3 m/s\"",
         [](const Case& c) {
             auto reason = why_no_column(c);
             // The velocity of a canal is that of its hydraulic radius. One that is drawn wrong is told of
             // that.
             const auto canal = std::find_if(c.solids.begin(), c.solids.end(),
                                             [](const Solid& solid) { return is_section(solid.shape); });
             const bool is_canal =
                 canal_of(c) != nullptr || (canal != c.solids.end() && !section_fault(c, *canal).empty());
             if (canal != c.solids.end() && c.solids.size() > 1) {
                 reason = fmt::format(
                     "\"{}\" is a cross-section beside other solids, and the velocity of a canal is known where "
                     "nothing stands in it",
                     canal->name);
             }
             const bool asked =
                 (starts_as(c, StartKind::uniform) && !is_canal) || starts_as(c, StartKind::power_law);
             return found_if(asked && c.channel.ends != Ends::open && !c.start.velocity && reason,
                             "velocity is missing, and the case has no column twin to take it from: {}",
                             reason.value_or(""));
         }},
        {{"start.packed", "channel.ends", "channel.top"},
         "`packed = true` between open ends under a free surface",
         "the rows of the water that enters are those of the lattice, drawn out to the surface",
         "remove the key",
         [](const Case& c) { return c.start.packed.value_or(false) && packing_meets_entering_rows(c); }},
        {{"start.packed", "solid.x", "channel.ends"},
         "`packed = true` with a solid near an open end",
         "the water within ten smoothing lengths of solids is moved, and that at the ends stands on the lattice",
         "make the channel longer, or remove packed",
         [](const Case& c) { return c.start.packed.value_or(false) && packing_reaches_an_open_end(c); }},
        {{"start.packed", "channel.top", "numerics.wall"},
         "`packed = true` in a periodic box, or with walls that are no layers of dummy particles",
         "it fills the water up between layers of wall particles as dense as the water",
         R"(remove the key, or choose wall = "dummy")",
         [](const Case& c) { return c.start.packed.value_or(false) && packing_lacks_wall_layers(c); }},
        {{"start.packed", "start.jitter"},
         "`packed = true` without solids and without `jitter`",
         "the lattice is even already, and no particle would move",
         "remove the key, or give jitter",
         [](const Case& c) {
             return c.start.packed.value_or(false) && c.solids.empty() && c.start.jitter == 0.0;
         }},
        {{"start.file", "start.kind"},
         "`file` missing with `kind = \"results\"`",
         "kind = \"results\" needs the results file to start from",
         "give it, for example file = \"run/results.h5\"",
         [](const Case& c) {
             return found_if(starts_as(c, StartKind::results) && c.start.file.empty(), "file is missing");
         }},
        {{"start.file", "start.kind"},
         "`file` missing with `kind = \"isotropic\"`",
         "the eddies have the energy spectrum of a table",
         "give it, for example file = \"spectrum.csv\"",
         [](const Case& c) {
             return found_if(starts_as(c, StartKind::isotropic) && c.start.file.empty(), "file is missing");
         }},
        lost_results("start.file", "a `file` that is not there",
                     [](const Case& c) { return is_lost(c, c.start.file); }),
        lost_file("measured.velocity_profile", "a `velocity_profile` that is not there",
                  [](const Case& c) { return is_lost(c, c.measured.velocity_profile); }),
        {{"start.amplitude", "start.kind"},
         "`amplitude` and `velocity` missing with `kind = \"standing-wave\"`",
         "a wave needs an amplitude of its surface or of its velocity",
         "give one, for example amplitude = \"1 mm\"",
         [](const Case& c) {
             return starts_as(c, StartKind::standing_wave) && c.start.amplitude <= 0.0 && !c.start.velocity;
         }},
        {{"start.amplitude", "channel.depth"},
         "`amplitude` of the total depth or more",
         "the troughs would reach the bed",
         "make it smaller",
         [](const Case& c) {
             return found_if(starts_as(c, StartKind::standing_wave) && c.start.amplitude >= c.total_depth(),
                             "amplitude is {}, not less than the depth {}", shown_length(c.start.amplitude),
                             shown_length(c.total_depth()));
         }},
        {{"start.velocity", "start.kind"},
         "`velocity` missing with `kind = \"taylor-green\"`",
         "the vortices need the amplitude of their velocity",
         "give it, for example velocity = \"1 m/s\"",
         [](const Case& c) {
             return found_if(starts_as(c, StartKind::taylor_green) && !c.start.velocity,
                             "velocity is missing");
         }},
        {{"start.kind", "channel.top"},
         R"(`kind = "taylor-green"` without `channel.top = "periodic"`)",
         "the vortices repeat over the height, which needs [channel] top = \"periodic\"",
         "set it",
         [](const Case& c) {
             return starts_as(c, StartKind::taylor_green) && c.channel.top != Top::periodic;
         }},
        {{"start.kind", "channel.dimensions", "channel.top"},
         R"(`kind = "isotropic"` in two dimensions, or without `channel.top = "periodic"`)",
         "isotropic turbulence fills a box in space that is periodic in all directions",
         R"(set [channel] dimensions = 3 and top = "periodic", or choose another start)",
         [](const Case& c) {
             return starts_as(c, StartKind::isotropic) &&
                    (c.channel.dimensions != 3 || c.channel.top != Top::periodic);
         }},
    }};
}

}  // namespace riffle::inline case_file
