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
}

}  // namespace riffle
