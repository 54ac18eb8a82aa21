#include "case/warnings.hpp"

#include <algorithm>
#include <cmath>

#include "case/bed_friction.hpp"
#include "case/bed_traits.hpp"
#include "case/conversion.hpp"
#include "case/cross_section.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/key_table.hpp"
#include "case/outline_check.hpp"
#include "case/presets.hpp"
#include "case/refusals.hpp"
#include "case/solid_shapes.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

// What is verified (docs/theory.md, section 18). In three dimensions the lowest layers are mixed among the
// spheres anyway.
double rows_over_depth(const Case& c) { return in_space(c) ? 10.0 : 20.0; }
double rows_in_roughness(const Case& c) { return in_space(c) ? 2.0 : 4.0; }
constexpr double most_jitter = 0.25;

/// Whether solids cover the bed.
bool covers_bed(const Case& c) {
    return std::any_of(c.solids.begin(), c.solids.end(),
                       [](const Solid& solid) { return is_bed_shape(solid.shape); });
}

/// Whether a solid that is not lifted holds the water at one edge of its outline, over its whole height.
bool is_held(const Case& c, double edge, double height) {
    const double touch = 2.0 * c.numerics.spacing;
    return std::any_of(c.solids.begin(), c.solids.end(), [&](const Solid& solid) {
        const auto x = extent_of(c, solid, 0);
        const auto z = extent_of(c, solid, 2);
        return solid.velocity_z <= 0.0 && x && z && x->low - touch <= edge && edge <= x->high + touch &&
               z->high + touch >= height;
    });
}

/// Whether the water falls, or meets a wall of a tank that it does not fill.
bool breaks(const Case& c) {
    if (c.start.water_x.empty() || c.channel.ends != Ends::walls) return false;
    const Extent x(c.start.water_x);
    const Extent z(c.start.water_z);
    // The front of a breaking dam without friction runs at twice sqrt(g h) (Ritter 1892).
    const double gap = std::max(is_held(c, x.low, z.high) ? 0.0 : x.low,
                                is_held(c, x.high, z.high) ? 0.0 : c.channel.length - x.high);
    const double front = 2.0 * std::sqrt(c.normal_gravity() * z.high);
    const bool arrives = gap > c.numerics.spacing && c.run.time * front > gap;
    return arrives || z.low > c.numerics.spacing;
}

/// "the depth", or "the depth of the inflow, 20 mm".
std::string depth_text(const LeastDepth& least) {
    return least.of == nullptr ? "the depth"
                               : fmt::format("the depth of {}, {}", least.of, shown_length(least.depth));
}

CheckList make_warnings() {
    return {{
        {{"numerics.spacing", "bed.roughness_height"},
         "fewer than 4 rows of particles in the roughness zone, in three dimensions fewer than 2",
         "the layers between the crests are not resolved",
         "make the spacing smaller",
         [](const Case& c) {
             const double rows = c.bed.roughness_height / c.numerics.spacing;
             return found_if(
                 over_spheres(c) && rows * (1 + rounding_of_ratios) < rows_in_roughness(c),
                 "{} leaves only {:.1f} rows in the roughness zone of {}, verified with {:.0f} and more",
                 shown_length(c.numerics.spacing), rows, shown_length(c.bed.roughness_height),
                 rows_in_roughness(c));
         }},
        {{"numerics.spacing", "channel.depth"},
         "fewer than 20 rows of particles over the total depth of a bed of spheres, or over a depth given at an open end of it, in three dimensions fewer than 10",
         "the layers of the flow may break up",
         "make the spacing smaller",
         [](const Case& c) {
             const LeastDepth least = least_named_depth(c);
             const double rows = least.depth / c.numerics.spacing;
             return found_if(over_spheres(c) && rows * (1 + rounding_of_ratios) < rows_over_depth(c),
                             "{} leaves only {:.0f} rows over {}, verified with {:.0f} and more",
                             shown_length(c.numerics.spacing), rows, depth_text(least), rows_over_depth(c));
         }},
        {{"turbulence.closure", "bed.kind"},
         R"(`closure = "none"` with `bed.kind = "spheres"`)",
         "a rough bed without a closure gives velocities far above any real flow",
         "choose a mixing length",
         [](const Case& c) { return !has_closure(c) && over_spheres(c); }},
        {{"turbulence.closure"},
         "`closure = \"sps\"`",
         "the constant-C_s model at this resolution gives a stress far below the weight of the water above, so the velocity does not settle at a real value, and it is offered to show this (docs/theory.md, section 7)",
         R"(use a mixing length ("ramp", "nezu-rodi", "nikuradse"))",
         [](const Case& c) { return c.turbulence.closure == ClosureKind::sps; }},
        {{"turbulence.closure", "channel.sides"},
         "`closure = \"sps\"` between side walls",
         R"(between side walls the constant-C_s model has no steady flow, and the run no cross-section twin; with start.kind = "section" it starts from that of the same channel with "czernuszenko-rylov")",
         "use \"czernuszenko-rylov\"",
         [](const Case& c) { return c.turbulence.closure == ClosureKind::sps && c.has_side_walls(); }},
        {{"bed.kind", "turbulence.closure"},
         "`kind = \"no-slip\"` with a closure of the mean flow",
         "a no-slip bed with a mixing length is under-resolved at this kind of spacing",
         "compare two spacings",
         [](const Case& c) { return has_closure(c) && !resolves_eddies(c) && is_no_slip(c.bed); }},
        {{"bed.kind", "turbulence.closure"},
         "`kind = \"no-slip\"` with resolved eddies, no bed of solids over it",
         "beside a plane bed at which the water rests the particles that overtake each other in its shear push each other up and down, and this noise takes the place of the eddies (docs/theory.md, section 7, what the particles do to eddies)",
         "compare two spacings; a bed of solid spheres, or of measured heights, was run with resolved eddies",
         [](const Case& c) { return resolves_eddies(c) && is_no_slip(c.bed) && !covers_bed(c); }},
        {{"numerics.spacing", "bed.equivalent_roughness"},
         "over a bed by roughness a spacing below k_s/33, the height of zero velocity of its log law",
         "the rows are finer than what the law says of the flow among the elements",
         "make the spacing larger",
         [](const Case& c) {
             const double zero =
                 zero_height_of_roughness(c.bed.equivalent_roughness.value_or(0.0), c.turbulence.kappa);
             return found_if(has_roughness(c.bed) && c.numerics.spacing < zero,
                             "{} is below the height of zero velocity of the log law, {}",
                             shown_length(c.numerics.spacing), fmt::format("{:.2g} mm", 1e3 * zero));
         }},
        {{"numerics.spacing", "channel.depth"},
         "fewer than 12 rows of particles over the depth of a bed by a wall law, or over a depth given at an open end but of a bed of spheres",
         "a row is a large part of the depth",
         "make the spacing smaller",
         [](const Case& c) {
             const LeastDepth least = least_named_depth(c);
             const double rows = least.depth / c.numerics.spacing;
             return found_if((has_wall_law(c) || (least.of != nullptr && !over_spheres(c))) &&
                                 rows * (1 + rounding_of_ratios) < 12.0,
                             "{} leaves only {:.0f} rows over {}, verified with 12 and more",
                             shown_length(c.numerics.spacing), rows, depth_text(least));
         }},
        {{"bed.drag_form"},
         "`drag_form = \"thesis\"`",
         "the form printed in the thesis scales as 1 / spacing, so the flow changes with the resolution",
         "\"consistent\" does not",
         [](const Case& c) { return over_spheres(c) && c.bed.drag_form == DragForm::thesis; }},
        {{"measured.uniform"},
         "`uniform = false`",
         "the measured flow was not uniform",
         "a uniform simulation need not agree with it",
         [](const Case& c) { return !c.measured.uniform; }},
        {{"numerics.preset", "start.water_x"},
         "water that falls or breaks against an end wall without `preset = \"violent\"`",
         "in this run water breaks against a wall or falls, pressures scatter and spray may leave the water",
         "such flows are verified with preset = \"violent\"",
         [](const Case& c) { return breaks(c) && c.numerics.preset != Preset::violent; }},
        {{"start.kind", "solid.name"},
         "`kind = \"backwater\"` with solids that stand in the water",
         "the varied flow of the start knows the bed alone: over a weir or past a pier the run begins with another "
         "flow, and has to find its own",
         "kind = \"rest\" with start.water_x and start.water_z gives each pool its level",
         [](const Case& c) { return c.start.kind == StartKind::backwater && has_solids_beside_section(c); }},
        {{"start.lattice", "start.kind"},
         "`lattice = \"body-centred\"` of water that does not start at rest",
         "\"body-centred\" has no layers that slide in a shear flow (docs/theory.md, section 12)",
         "verified with \"square\"",
         [](const Case& c) {
             return c.start.lattice == StartLattice::body_centred && c.start.kind != StartKind::rest;
         }},
        {{"start.jitter"},
         "`jitter` above 0.25",
         "particles so near to each other may throw the start apart",
         "verified up to 0.25 spacings",
         [](const Case& c) { return c.start.jitter > most_jitter; }},
    }};
}

/// Keys that differ from their default though nothing uses them.
void warn_of_keys_without_effect(const Case& c, std::vector<std::string>& messages) {
    Case defaults;
    defaults.numerics = preset_numerics(c.numerics.preset, c.channel.dimensions);
    for (const SectionKeys& section : key_table()) {
        for (const Key& key : section.keys) {
            if (!key.applies.strictly && !key_applies(key, c) && key.get(c) != key.get(defaults)) {
                messages.push_back(fmt::format("{} = {} has no effect: it is used only with {} = \"{}\"",
                                               key.id(), value_text(key, key.get(c)), key.applies.id,
                                               fmt::join(key.applies.words, "\", \"")));
            }
        }
    }
}

}  // namespace

const CheckList& warnings() {
    static const CheckList list = [] {
        CheckList all = make_warnings();
        for (const CheckList& more : {numerics_warnings(), patch_warnings(), solid_warnings()}) {
            all.checks.insert(all.checks.end(), more.checks.begin(), more.checks.end());
        }
        return all;
    }();
    return list;
}

std::vector<std::string> case_warnings(const Case& c) {
    std::vector<std::string> messages;
    for_each_finding(warnings(), c, [&](const CaseCheck& check, const CaseFinding& finding) {
        messages.push_back(
            check.keys.front() + ": " +
            finding_text(finding.detail.empty() ? finding.name : finding.detail, check, finding));
    });
    warn_of_keys_without_effect(c, messages);
    return messages;
}

}  // namespace riffle::inline case_file
