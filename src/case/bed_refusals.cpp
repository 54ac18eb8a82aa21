#include <utility>

#include "case/refusals.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {

/// A roughness zone of a bed without spheres.
Findings zone_of_smooth_bed(const Case& c) {
    Findings found;
    for (const auto& [name, value] : {std::pair("roughness_height", c.bed.roughness_height),
                                      std::pair("datum_below_crest", c.bed.datum_below_crest)}) {
        if (!over_spheres(c) && value != 0.0) {
            found.push_back(
                {.detail = fmt::format("{} is {}, but a smooth bed (kind = \"{}\") has no roughness zone",
                                       name, shown_length(value), word(c.bed.kind)),
                 .key = fmt::format("bed.{}", name)});
        }
    }
    return found;
}

}  // namespace

CheckList bed_refusals() {
    return {{
        {{"bed.roughness_height", "bed.datum_below_crest"},
         "`roughness_height` or `datum_below_crest` other than 0 without `kind = \"spheres\"`",
         "",
         "remove the key, set it to 0, or choose kind = \"spheres\"",
         zone_of_smooth_bed},
        {{"bed.roughness_height"},
         "`roughness_height` 0 with `kind = \"spheres\"`",
         "a bed of spheres needs a roughness zone",
         R"(give a length or a multiple of the sphere diameter such as "0.4 D", or choose kind = "slip" or "no-slip")",
         [](const Case& c) { return over_spheres(c) && c.bed.roughness_height <= 0.0; },
         true},
        {{"bed.roughness_height", "bed.sphere_diameter"},
         "`roughness_height` above `sphere_diameter`",
         "the drag needs the chord of the sphere at each height",
         "give at most one diameter, \"1 D\"",
         [](const Case& c) {
             return found_if(over_spheres(c) && c.bed.roughness_height > c.bed.sphere_diameter,
                             "roughness_height is {}, more than the sphere diameter {}",
                             shown_length(c.bed.roughness_height), shown_length(c.bed.sphere_diameter));
         }},
        {{"bed.datum_below_crest", "bed.roughness_height"},
         "`datum_below_crest` above `roughness_height`",
         "the depth is measured from a height in the roughness zone",
         "give at most the roughness height",
         [](const Case& c) {
             return found_if(over_spheres(c) && c.bed.datum_below_crest > c.bed.roughness_height,
                             "datum_below_crest is {}, below the bed level with a roughness height of {}",
                             shown_length(c.bed.datum_below_crest), shown_length(c.bed.roughness_height));
         }},
        {{"numerics.spacing", "bed.roughness_height"},
         "`spacing` above `bed.roughness_height`",
         "no particle would resolve the roughness zone",
         "make the spacing a quarter of that or less",
         [](const Case& c) {
             return found_if(over_spheres(c) && c.numerics.spacing > c.bed.roughness_height,
                             "spacing is {}, larger than the roughness height {}",
                             shown_length(c.numerics.spacing), shown_length(c.bed.roughness_height));
         }},
    }};
}

}  // namespace riffle
