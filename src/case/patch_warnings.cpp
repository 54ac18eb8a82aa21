#include <algorithm>

#include "case/cross_section.hpp"
#include "case/flow_kind.hpp"
#include "case/porous_zone.hpp"
#include "case/units.hpp"
#include "case/warnings.hpp"

namespace riffle::inline case_file {

namespace {

constexpr double comparison_slack = 1e-9;  ///< for the comparison of ratios given as decimals

// What is verified (docs/theory.md, section 18).
constexpr double most_solid_fraction = 0.12;
constexpr double fewest_rows_in_stems = 5.0;
constexpr double largest_edge_share = 0.1;

}  // namespace

CheckList patch_warnings() {
    return {{
        {{"vegetation.stems_per_area", "vegetation.stem_diameter"},
         "stems that fill more than 0.12 of the water",
         "the drag coefficients of stems were measured in sparser arrays (docs/theory.md, section 8, vegetation)",
         "calibrate drag_coefficient",
         [](const Case&, const Vegetation& patch) {
             return found_if(patch.solid_fraction() > most_solid_fraction,
                             "fills a share of {:.3g} of the water", patch.solid_fraction());
         }},
        {{"vegetation.height", "numerics.spacing"},
         "fewer than 5 rows of particles below the tops of submerged stems",
         "the shear layer at the tops is as thick as they leave it (docs/vegetation.md)",
         "make the spacing smaller",
         [](const Case& c, const Vegetation& patch) {
             const double rows = patch.height / c.numerics.spacing;
             return found_if(
                 patch.height < c.total_depth() && rows * (1 + comparison_slack) < fewest_rows_in_stems,
                 "{} rows stand below the tops", fmt::format("{:.1f}", rows));
         }},
        {{"turbulence.closure", "vegetation.name"},
         "submerged stems without a mixing length",
         "the length of the eddies at the tops of the stems is part of a mixing length alone (docs/theory.md, section 7, canopies)",
         "verified with closure = \"nezu-rodi\"",
         [](const Case& c) {
             return !has_mixing_length(c) &&
                    std::any_of(c.vegetation.begin(), c.vegetation.end(),
                                [&c](const Vegetation& patch) { return patch.height < c.total_depth(); });
         }},
        {{"bed_patch.kind", "solid.shape"},
         "patches of the bed below a bed of measured heights or a cross-section",
         "a patch is of the plane bed, which the water does not touch there: its friction acts nowhere",
         "give the solid itself an equivalent_roughness, or make it of several solids with their own",
         [](const Case& c, const BedPatch&) {
             return found_if(std::any_of(c.solids.begin(), c.solids.end(),
                                         [](const Solid& solid) {
                                             return is_section(solid.shape) || solid.shape == SolidShape::bed;
                                         }),
                             "the plane bed lies below a solid all along the channel");
         }},
        {{"porous.edge", "porous.z_to", "porous.name"},
         "a porous zone thinner than the edge over which its porosity changes",
         "nowhere in it is the porosity that of the medium (docs/porous.md)",
         "make the spacing smaller, or give a thinner edge",
         [](const Case& c, const Porous& zone) {
             const double edge = porous_edge(c, zone);
             const double upright = zone.z_to.value_or(c.total_depth()) - zone.z_from.value_or(0.0);
             const double along = zone.x_to.value_or(c.channel.length) - zone.x_from.value_or(0.0);
             const double beside = is_outlined(zone) ? least_extent(c, zone) : along;
             const double least = std::min(covers_length(c, zone) ? upright : beside, upright);
             return found_if(
                 !is_seen_from_the_side(zone) && zone.top_z.empty() && edge > least * (1 + comparison_slack),
                 "the edge has {}, and the zone {} in one direction", shown_length(edge),
                 shown_length(least));
         }},
        {{"porous.edge", "porous.name", "numerics.spacing"},
         "a porous layer all along a stream whose `edge` is thicker than a tenth of the water above it",
         "half of the edge lies in that water, which runs along it: its velocity follows the edge, and the default edge "
         "follows the spacing (docs/porous.md, edges and the width of the kernel)",
         "give an edge of your own, a smoothing length or less, and the same at all spacings",
         [](const Case& c, const Porous& zone) {
             const double top = zone.top_z.empty() ? zone.z_to.value_or(c.total_depth()) : zone.top_z.front();
             const double above = c.total_depth() - top;
             const double edge = porous_edge(c, zone);
             const bool stream = c.channel.ends != Ends::walls && c.streamwise_gravity() > 0.0;
             return found_if(stream && !is_seen_from_the_side(zone) && covers_length(c, zone) &&
                                 above > 0.0 && edge > largest_edge_share * above * (1 + comparison_slack),
                             "the edge has {} and the water above {}", shown_length(edge),
                             shown_length(above));
         }},
        {{"turbulence.zero", "porous.name"},
         "a mixing length that begins below the top of a porous layer",
         "it grows with the distance from where it begins, and the eddies above a layer grow from its top",
         "give the height of the top",
         [](const Case& c, const Porous& zone) {
             const double top = zone.top_z.empty() ? zone.z_to.value_or(0.0) : zone.top_z.front();
             return found_if(has_mixing_length(c) && covers_length(c, zone) && top < c.total_depth() &&
                                 c.turbulence.zero < top * (1 - comparison_slack),
                             "the layer reaches to {}, and the mixing length begins at {}", shown_length(top),
                             shown_length(c.turbulence.zero));
         }},
    }};
}

}  // namespace riffle::inline case_file
