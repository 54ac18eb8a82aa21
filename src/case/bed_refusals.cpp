#include <utility>

#include "case/bed_friction.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

/// A roughness zone of a bed without spheres or solids.
Findings zone_of_plane_bed(const Case& c) {
    Findings found;
    for (const auto& [name, value] : {std::pair("roughness_height", c.bed.roughness_height),
                                      std::pair("datum_below_crest", c.bed.datum_below_crest)}) {
        if (!has_rough_bed(c) && value != 0.0) {
            found.push_back(
                {.detail = fmt::format("{} is {}, but a plane bed (kind = \"{}\") has no roughness zone",
                                       name, shown_length(value), word(c.bed.kind)),
                 .key = fmt::format("bed.{}", name)});
        }
    }
    return found;
}

/// Largest k_s over the depth: the log law needs water above the elements.
constexpr double most_roughness = 0.5;

/// Rows of particles over the depth of which the five of the wall layer (docs/theory.md, section 8) are few.
constexpr double fewest_rows = 10.0;

bool by_roughness(const Case& c) { return has_roughness(c.bed); }

/// Manning's n of the uniform flow of the log law over a height of zero velocity, at the depth of the case.
double manning_over(const Case& c, double zero_height) {
    const double depth = c.total_depth();
    return velocity_ratio_of_manning(log_law_mean(depth, zero_height, c.turbulence.kappa), depth,
                                     c.fluid.gravity);
}

double roughest_manning(const Case& c) {
    return manning_over(c, zero_height_of_roughness(most_roughness * c.total_depth(), c.turbulence.kappa));
}

/// Of a smooth bed; 0 without a slope or viscosity.
double smoothest_manning(const Case& c) {
    const double length = c.fluid.kinematic_viscosity / reference_friction_velocity(c);
    return c.channel.slope > 0.0 && length > 0.0
               ? manning_over(c, zero_height_of_smooth_wall(length, c.turbulence.kappa))
               : 0.0;
}

}  // namespace

CheckList wall_law_refusals() {
    return {
        {
            {{"bed.equivalent_roughness", "bed.manning"},
             "`kind = \"roughness\"` with neither or both of `equivalent_roughness` and `manning`",
             "the friction of the bed follows from one of them",
             "give one of the two",
             [](const Case& c) {
                 return found_if(
                     by_roughness(c) && c.bed.equivalent_roughness.has_value() == c.bed.manning.has_value(),
                     "kind = \"roughness\" with {} of equivalent_roughness and manning",
                     c.bed.manning ? "both" : "neither");
             },
             true},
            {{"bed.equivalent_roughness", "channel.depth"},
             "`equivalent_roughness` above half of the depth",
             "the log law needs water above the elements of the bed",
             "give less, or resolve the elements as [[solid]] bodies",
             [](const Case& c) {
                 const double roughness = c.bed.equivalent_roughness.value_or(0.0);
                 return found_if(roughness > most_roughness * c.total_depth(),
                                 "equivalent_roughness is {}, and the water {} deep", shown_length(roughness),
                                 shown_length(c.total_depth()));
             }},
            {{"bed.manning", "channel.depth"},
             "`manning` of a bed rougher than half of the depth, or smoother than a smooth one",
             "in water of a depth n says how rough the bed is, by the log law",
             "correct it, or the depth",
             [](const Case& c) {
                 const double n = c.bed.manning.value_or(0.0);
                 Findings found =
                     found_if(c.bed.manning && n > roughest_manning(c),
                              "manning is {:g}: at a depth of {} the roughness would be more than "
                              "half of the depth from {:.3g} on",
                              n, shown_length(c.total_depth()), roughest_manning(c));
                 if (found.empty()) {
                     found = found_if(c.bed.manning && n < smoothest_manning(c),
                                      "manning is {:g}: at a depth of {} a smooth bed has {:.3g}", n,
                                      shown_length(c.total_depth()), smoothest_manning(c));
                 }
                 return found;
             }},
            {{"bed.kind", "turbulence.closure"},
             R"(`kind = "roughness"` or `"smooth"` without a mixing length)",
             "the law of the wall is that of a mixing length",
             R"(choose closure = "ramp", "nezu-rodi", "nikuradse" or "czernuszenko-rylov", or kind = "no-slip" for laminar flow)",
             [](const Case& c) { return !has_mixing_length(c); }},
            {{"turbulence.zero", "bed.kind"},
             "`zero` other than 0 over a bed by a wall law",
             "the law says where the mixing length begins",
             "remove zero",
             [](const Case& c) { return c.turbulence.zero != 0.0; }},
            {{"bed.kind", "fluid.kinematic_viscosity"},
             "`kind = \"smooth\"` without viscosity",
             "the friction of a smooth wall is that of its viscous layer",
             "give the viscosity of the water, 1e-6",
             [](const Case& c) {
                 return has_wall_law(c) && !has_roughness(c.bed) && c.fluid.kinematic_viscosity <= 0.0;
             }},
            {{"bed.kind", "numerics.wall"},
             "a bed by a wall law with `wall = \"dynamic\"`",
             "the water rests at such walls, and the friction would count twice",
             "choose wall = \"dummy\"",
             [](const Case& c) { return c.numerics.wall == WallKind::dynamic; }},
            {{"bed.kind", "channel.top"},
             "a bed by a wall law without a free surface",
             "its law is that of the depth of a channel",
             "set [channel] top = \"free-surface\"",
             [](const Case& c) { return !has_free_surface(c); }},
            {{"numerics.spacing", "channel.depth"},
             "fewer than 10 rows of particles over a bed by a wall law",
             "the friction acts over five rows, which must be a small part of the depth",
             "make the spacing smaller",
             [](const Case& c) {
                 const double rows = c.total_depth() / c.numerics.spacing;
                 return found_if(rows * (1 + 1e-9) < fewest_rows, "spacing is {}, which leaves {:.1f} rows",
                                 shown_length(c.numerics.spacing), rows);
             }},
        },
        has_wall_law};
}

CheckList bed_refusals() {
    return {{
        {{"bed.roughness_height", "bed.datum_below_crest"},
         "`roughness_height` or `datum_below_crest` other than 0 without `kind = \"spheres\"`, and without a solid "
         "that is `part_of_bed`",
         "",
         "remove the key, set it to 0, choose kind = \"spheres\", or set part_of_bed = true under the [[solid]] that "
         "makes the bed rough",
         zone_of_plane_bed},
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
             return found_if(has_rough_bed(c) && c.bed.datum_below_crest > c.bed.roughness_height,
                             "datum_below_crest is {}, below the bed level with a roughness height of {}",
                             shown_length(c.bed.datum_below_crest), shown_length(c.bed.roughness_height));
         }},
        {{"bed.roughness_height", "solid.part_of_bed"},
         "`roughness_height` above the highest point of the solids that are part of the bed",
         "the crests are theirs",
         "give at most that height, or remove the key: the crests are the highest points then",
         [](const Case& c) {
             const auto highest = highest_of_solid_bed(c);
             return found_if(highest && !over_spheres(c) && c.bed.roughness_height > *highest + 1e-9,
                             "roughness_height is {}, and the highest point is at {}",
                             shown_length(c.bed.roughness_height), shown_length(highest.value_or(0.0)));
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

}  // namespace riffle::inline case_file
