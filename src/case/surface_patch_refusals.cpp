#include "case/bed_friction.hpp"
#include "case/gauge_face.hpp"
#include "case/patch_checks.hpp"
#include "case/refusals.hpp"
#include "case/surface_roughness.hpp"

namespace riffle::inline case_file {

namespace {

/// The solid that a patch is a part of, which there must be.
const Solid& solid_of(const Case& c, const SurfacePatch& patch) {
    return c.solids[*solid_named(c, patch.solid)];
}

}  // namespace

CheckList surface_patch_refusals() {
    return {
        plan_outline_rows<SurfacePatch>(
            "surface_patch",
            {
                {{"surface_patch.name"},
                 "an empty `name`",
                 "messages name the patch",
                 "give one",
                 [](const Case&, const SurfacePatch& patch) {
                     return found_if(patch.name.empty(), "name is empty");
                 }},
                {{"surface_patch.name"},
                 "the `name` of another patch of a surface",
                 "each needs its own",
                 "choose another one",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(repeats_a_name(c.surface_patches, patch),
                                     "another patch has this name already");
                 }},
                {{"surface_patch.solid", "solid.name"},
                 "a patch of a `solid` that is not there",
                 "",
                 "give the name of a [[solid]] of the case",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(!solid_named(c, patch.solid), "no [[solid]] is called \"{}\"",
                                     patch.solid);
                 },
                 true},
                {{"surface_patch.solid", "solid.surface"},
                 "a patch of a solid whose surface has no log law",
                 "other surfaces have no roughness",
                 R"(set surface = "log-law" of the solid)",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(solid_of(c, patch).surface != SolidSurface::log_law,
                                     "the surface of \"{}\" has no log law", patch.solid);
                 },
                 true},
                {{"surface_patch.solid", "solid.motion"},
                 "a patch of a solid that moves",
                 "a patch lies at its place in plan, from which the solid would move away",
                 "give the whole solid one roughness, or make the parts solids of their own",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(!solid_of(c, patch).rests(), "\"{}\" moves", patch.solid);
                 }},
                {{"surface_patch.equivalent_roughness", "surface_patch.manning"},
                 "neither `equivalent_roughness` nor `manning` of a patch, or both",
                 "either tells how rough it is",
                 "give one of them",
                 [](const Case&, const SurfacePatch& patch) {
                     return found_if(patch.equivalent_roughness.has_value() == patch.manning.has_value(),
                                     "{}", patch.manning ? "both are given" : "neither is given");
                 },
                 true},
                {{"surface_patch.manning", "channel.depth"},
                 "a `manning` that no roughness up to the depth of the case has",
                 "",
                 "give another n, equivalent_roughness, or [[vegetation]] for what stands in the water",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(patch.manning && !roughness_of_surface_manning(c, *patch.manning),
                                     "no k_s up to the depth of {} has n = {:g}",
                                     shown_length(c.total_depth()), patch.manning.value_or(0.0));
                 },
                 true},
                {{"surface_patch.equivalent_roughness", "fluid.kinematic_viscosity"},
                 "a smooth patch without viscosity",
                 "the friction of a smooth wall is that of its viscous layer",
                 "give the viscosity of the water, 1e-6, or a roughness",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(surface_roughness(c, patch) <= 0.0 && c.fluid.kinematic_viscosity <= 0.0,
                                     "its surface is smooth, and the water has no viscosity");
                 }},
                {{"surface_patch.equivalent_roughness", "surface_patch.manning", "numerics.spacing"},
                 "a roughness of a patch above three spacings",
                 "the friction acts in a layer of three spacings, in which the log law must have begun",
                 "make the roughness smaller or the spacing larger, or let [[vegetation]] hold the water back",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(surface_roughness(c, patch) > solid_friction_layer(c),
                                     "k_s is {}, three spacings are {}",
                                     shown_length(surface_roughness(c, patch)),
                                     shown_length(solid_friction_layer(c)));
                 }},
                {{"surface_patch.x_from", "surface_patch.x_to", "surface_patch.y_from", "surface_patch.y_to",
                  "surface_patch.x", "surface_patch.y", "surface_patch.name"},
                 "a patch that begins or ends outside of the channel, or ends before it begins",
                 "",
                 "correct the range; without the keys the patch reaches to the end or the side of the channel",
                 [](const Case& c, const SurfacePatch& patch) {
                     return beyond_channel(c, patch, "surface_patch");
                 }},
                {{"surface_patch.x_to", "surface_patch.y_to", "numerics.spacing"},
                 "a patch shorter or narrower than a spacing of the particles",
                 "no particle would resolve it",
                 "make the spacing smaller or the patch larger",
                 [](const Case& c, const SurfacePatch& patch) {
                     return below_spacing(c, least_extent(c, patch));
                 }},
                {{"surface_patch.x_from", "surface_patch.name"},
                 "a patch that covers the whole channel",
                 "nothing is left of the solid's own roughness",
                 "give it as that of the [[solid]], or a range to the patch",
                 [](const Case& c, const SurfacePatch& patch) {
                     return found_if(covers_length(c, patch) && covers_width(c, patch),
                                     "covers all of the channel");
                 }},
                {{"surface_patch.name"},
                 "a patch that lies where another one of the same solid does",
                 "a place has one roughness",
                 "give patches beside each other",
                 [](const Case& c, const SurfacePatch& patch) {
                     const SurfacePatch* const other = patch_below<SurfacePatch>(
                         c, c.surface_patches, patch,
                         [&](const SurfacePatch& one) { return one.solid == patch.solid; });
                     return other != nullptr ? found_if(true, "lies where \"{}\" does", other->name)
                                             : Findings{};
                 }},
            }),
        [](const Case& c) { return !c.surface_patches.empty(); }};
}

}  // namespace riffle::inline case_file
