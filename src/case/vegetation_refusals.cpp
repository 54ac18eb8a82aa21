#include <algorithm>
#include <numbers>
#include <optional>

#include "case/gauge_face.hpp"
#include "case/patch_checks.hpp"
#include "case/refusals.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_places.hpp"
#include "case/stem_feet.hpp"

namespace riffle::inline case_file {

namespace {

/// phi at which stems on a square lattice touch.
constexpr double touching = std::numbers::pi / 4.0;

Findings thinner_than_a_particle(const Case& c, const Vegetation& patch) {
    return below_spacing(c, std::min(patch.height, least_extent(c, patch)));
}

/// The middle of the i-th of some equal parts of a range, m.
double middle_of_part(const PatchRange& range, int i, int parts) {
    return range.from + (i + 0.5) / parts * (range.to - range.from);
}

/// Nowhere among its stems, up to their tops, is there water: solids at rest take it up.
Findings in_solids(const Case& c, const Vegetation& patch) {
    if (c.solids.empty()) {
        return {};
    }
    const SolidPlaces solids(c);
    const auto ranges = ranges_of(c, patch);
    // As near to each other as the particles, but no more than some ten thousands.
    const double most = in_space(c) ? 24.0 : 160.0;
    const auto steps = [&](double extent) {
        return static_cast<int>(std::clamp(extent / c.numerics.spacing, 1.0, most));
    };
    const int columns = steps(ranges[0].to - ranges[0].from);
    const int files = in_space(c) ? steps(ranges[1].to - ranges[1].from) : 1;
    const int rows = steps(std::min(patch.height, c.total_depth()));
    const Outline plan = plan_outline(c, patch);
    std::optional<std::size_t> solid;
    for (int i = 0; i < columns * files * rows; ++i) {
        const double x = middle_of_part(ranges[0], i % columns, columns);
        const double y = middle_of_part(ranges[1], i / columns % files, files);
        if (in_space(c) && !contains(plan, x, y)) continue;
        const double foot = stem_foot(c, patch, x, y);
        const double top = std::min(foot + patch.height, std::max(foot, c.total_depth()));
        solid = solids.resting_at({x, y, middle_of_part({foot, top}, i / columns / files, rows)});
        if (!solid) {
            return {};
        }
    }
    return solid ? found_if(true, "up to the tops of its stems it stands in the solid \"{}\"",
                            c.solids[*solid].name)
                 : Findings{};
}

/// Nowhere below it is the solid that its stems are said to stand on.
Findings beside_its_solid(const Case& c, const Vegetation& patch) {
    const auto solid = solid_named(c, patch.stands_on);
    if (!solid || !c.solids[*solid].rests() || (in_space(c) && mesh_of(c, c.solids[*solid]) == nullptr)) {
        return {};
    }
    const auto ranges = ranges_of(c, patch);
    constexpr int along = 100;
    const int across = in_space(c) ? 50 : 1;
    const Outline plan = plan_outline(c, patch);
    for (int i = 0; i < along * across; ++i) {
        const double x = middle_of_part(ranges[0], i % along, along);
        const double y = middle_of_part(ranges[1], i / along, across);
        if (in_space(c) && !contains(plan, x, y)) continue;
        if (solid_top(c, c.solids[*solid], x, y)) return {};
    }
    return found_if(true, "none of the solid \"{}\" lies below it", patch.stands_on);
}

}  // namespace

CheckList vegetation_refusals() {
    return {
        plan_outline_rows<Vegetation>(
            "vegetation",
            {
                {{"vegetation.name", "channel.top"},
                 "a `[[vegetation]]` with `channel.top = \"periodic\"`",
                 "a box without bed and surface has nothing that stems could stand on",
                 R"(set [channel] top = "free-surface", or remove the vegetation)",
                 [](const Case& c) { return c.channel.top == Top::periodic; },
                 true},
                {{"vegetation.name"},
                 "an empty `name`",
                 "messages name the patch",
                 "give one",
                 [](const Case&, const Vegetation& patch) {
                     return found_if(patch.name.empty(), "name is empty");
                 }},
                {{"vegetation.name"},
                 "the `name` of another patch of vegetation",
                 "each needs its own",
                 "choose another one",
                 [](const Case& c, const Vegetation& patch) {
                     return found_if(repeats_a_name(c.vegetation, patch),
                                     "another patch has this name already");
                 }},
                {{"vegetation.stems_per_area", "vegetation.stem_diameter"},
                 "stems so many and thick that they would touch on a square lattice, phi = n pi d^2/4 at pi/4 or above",
                 "no water would flow between them",
                 "correct one of the two; a unit may be wrong",
                 [](const Case&, const Vegetation& patch) {
                     return found_if(patch.solid_fraction() >= touching,
                                     "stems_per_area and stem_diameter fill a share of {:.3g} of the water",
                                     patch.solid_fraction());
                 }},
                {{"vegetation.vogel_exponent", "vegetation.reference_velocity"},
                 "`vogel_exponent` other than 0 without `reference_velocity`, or the latter without the former",
                 "the drag of flexible stems falls from a velocity on, up to which they stand",
                 "give both or neither",
                 [](const Case&, const Vegetation& patch) {
                     return found_if((patch.vogel_exponent != 0.0) != patch.reference_velocity.has_value(),
                                     "{} is missing",
                                     patch.reference_velocity ? "vogel_exponent" : "reference_velocity");
                 }},
                {{"vegetation.vogel_exponent", "vegetation.drag_coefficient"},
                 "`vogel_exponent` of -1.57 or less with the drag coefficient of Cheng & Nguyen",
                 "that coefficient falls like u^-0.43, and the force on the stems would fall as the velocity rises",
                 "give a drag_coefficient, or a vogel_exponent nearer to 0; plants have -0.2 to -1.2",
                 [](const Case&, const Vegetation& patch) {
                     constexpr double steepest = 0.43;  // of the coefficient
                     return found_if(!patch.drag_coefficient && 2.0 - steepest + patch.vogel_exponent <= 0.0,
                                     "vogel_exponent is {:g}", patch.vogel_exponent);
                 }},
                {{"vegetation.height", "channel.top"},
                 "`height` above a wall at the top",
                 "stems stand between bed and wall",
                 "give at most the depth",
                 [](const Case& c, const Vegetation& patch) {
                     return found_if(
                         c.channel.top == Top::wall && patch.height > c.total_depth() * (1 + 1e-9),
                         "height is {}, and the wall lies at {}", shown_length(patch.height),
                         shown_length(c.total_depth()));
                 }},
                {{"vegetation.x_from", "vegetation.x_to", "vegetation.y_from", "vegetation.y_to",
                  "vegetation.x", "vegetation.y", "vegetation.name"},
                 "a patch that begins or ends outside of the channel, or ends before it begins",
                 "",
                 "correct the range; without the keys the patch covers the whole channel",
                 [](const Case& c, const Vegetation& patch) {
                     return beyond_channel(c, patch, "vegetation");
                 }},
                {{"vegetation.height", "vegetation.x_to", "vegetation.y_to", "numerics.spacing"},
                 "a patch lower, shorter or narrower than a spacing of the particles",
                 "no particle would resolve it",
                 "make the spacing smaller or the patch larger",
                 thinner_than_a_particle},
                {{"vegetation.name"},
                 "a patch that stands where another one does",
                 "the mixing length of a place is that of one kind of stems",
                 "give patches beside each other, or their stems together as one kind",
                 [](const Case& c, const Vegetation& patch) {
                     const Vegetation* const other = patch_below(c, c.vegetation, patch);
                     return other ? found_if(true, "stands where \"{}\" does", other->name) : Findings{};
                 }},
                {{"vegetation.name", "vegetation.height", "solid.name"},
                 "a patch whose stems end in solids",
                 "no water would flow between them; heights count from the bed level without `stands_on`",
                 R"(name what they stand on (stands_on = "..."), or give stems that reach out of it or another place)",
                 in_solids},
                {{"vegetation.stands_on"},
                 "a `stands_on` that no [[solid]] has the name of",
                 "stems stand on the bed or on the top of a solid",
                 "correct the name, or remove the key for stems on the bed",
                 [](const Case& c, const Vegetation& patch) {
                     return found_if(!patch.stands_on.empty() && !solid_named(c, patch.stands_on),
                                     "no [[solid]] has the name \"{}\"", patch.stands_on);
                 }},
                {{"vegetation.stands_on", "solid.motion"},
                 "a `stands_on` of a solid that moves",
                 "stems do not move",
                 "name a solid at rest",
                 [](const Case& c, const Vegetation& patch) {
                     const auto solid = solid_named(c, patch.stands_on);
                     return found_if(solid && !c.solids[*solid].rests(), "the solid \"{}\" moves",
                                     patch.stands_on);
                 }},
                {{"vegetation.stands_on", "vegetation.x_from", "vegetation.y_from"},
                 "a `stands_on` of a solid that lies nowhere below the patch",
                 "the stems would stand on the bed",
                 "correct the name or the place of the patch, or remove the key",
                 beside_its_solid},
            }),
        [](const Case& c) { return !c.vegetation.empty(); }};
}

}  // namespace riffle::inline case_file
