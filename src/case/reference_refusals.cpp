#include "case/refusals.hpp"

namespace riffle::inline case_file {

namespace {

bool acts(const Case& c) { return c.numerics.reference_pressure == ReferencePressure::hydrostatic; }

}  // namespace

CheckList reference_refusals() {
    return {
        {
            {{"numerics.reference_pressure", "channel.top"},
             "`reference_pressure = \"hydrostatic\"` without a free surface",
             "between plates and in periodic boxes gravity adds a pressure that no particle feels",
             R"(set reference_pressure = "none", or [channel] top = "free-surface")",
             [](const Case& c) { return !has_free_surface(c); }},
            {{"numerics.reference_pressure", "channel.ends"},
             R"(`reference_pressure = "hydrostatic"` between open ends with an outflow that is `"free"` or `"free-fall"`, or an outline of the water at the start)",
             "it is a function of the height below one level, and the surface of such water falls far below it",
             "set reference_pressure = \"none\"",
             [](const Case& c) {
                 return c.channel.ends == Ends::open &&
                        (c.outflow.kind == OutflowKind::free || c.outflow.kind == OutflowKind::free_fall ||
                         !c.start.water_x.empty());
             }},
            {{"numerics.reference_pressure", "numerics.wall"},
             R"(`reference_pressure = "hydrostatic"` with a `wall` other than `"dummy"`)",
             "the other walls take the whole pressure from the density",
             R"(choose wall = "dummy", or reference_pressure = "none")",
             [](const Case& c) { return c.numerics.wall != WallKind::dummy; }},
            {{"numerics.reference_pressure", "solid.motion"},
             "`reference_pressure = \"hydrostatic\"` with a solid that moves",
             "it would have to hold the solid too, and the surface moves with it",
             R"(choose motion = "fixed", or reference_pressure = "none")",
             [](const Case&, const Solid& solid) { return !solid.rests(); }},
            {{"numerics.reference_pressure", "porous.name"},
             "`reference_pressure = \"hydrostatic\"` with porous zones",
             "their grains share the room of the water that it would hold",
             "set reference_pressure = \"none\"",
             [](const Case& c) { return !c.porous.empty(); }},
        },
        acts};
}

}  // namespace riffle::inline case_file
