#include "case/wall_validation.hpp"

#include <fmt/format.h>

#include "case/words.hpp"

namespace riffle {

namespace {

/// A key whose value a kind of wall does not go with, why, and what to do.
struct Conflict {
    bool present = false;
    const char* key = "";
    const char* reason = "";
};

}  // namespace

void validate_walls(const Case& c, const Places& places, Problems& problems) {
    const WallKind kind = c.numerics.wall;
    const auto refuse = [&](const Conflict& conflict) {
        if (conflict.present) {
            problems.add(places.of_first({conflict.key, "numerics.wall"}),
                         fmt::format("[numerics] wall = \"{}\" {}", word(kind), conflict.reason));
        }
    };
    if (kind == WallKind::modified_dynamic) {
        refuse(
            {!c.solids.empty(), "solid.name",
             "finds its density at mirror images in plane walls, which the outline of a [[solid]] does not "
             "have: choose \"dummy\", or remove the solids"});
    }
    if (kind != WallKind::repulsive) {
        return;
    }
    refuse({c.bed.kind == BedKind::no_slip, "bed.kind",
            "pushes along the normal alone, and nothing holds the water back along it: choose [bed] kind = "
            "\"slip\" or \"spheres\", or wall = \"dummy\""});
    refuse({c.channel.top != Top::free_surface, "channel.top",
            "scales its force with the depth below a free surface, which must be there: set [channel] top = "
            "\"free-surface\", or choose wall = \"dummy\""});
    refuse(
        {c.numerics.pressure_form == PressureForm::corrected, "numerics.pressure_form",
         "has no particles that complete the kernel, and pressure_form = \"corrected\" would take it for a "
         "free surface: choose pressure_form = \"symmetric\" or \"riemann\", or wall = \"dummy\""});
    refuse({c.channel.dimensions == 3 && c.channel.sides == Sides::half, "channel.sides",
            "cannot stand in for a plane of symmetry, which must mirror the water and not push it: choose "
            "[channel] sides = \"walls\" or \"periodic\", or wall = \"dummy\""});
    refuse({!c.solids.empty(), "solid.name",
            "is made of planes, which the outline of a [[solid]] is not: choose \"dummy\", or remove the "
            "solids"});
}

}  // namespace riffle
