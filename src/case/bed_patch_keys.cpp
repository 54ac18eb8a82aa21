#include "case/bed_patch_keys.hpp"

#include <utility>

#include "case/bed_traits.hpp"
#include "case/patch_keys.hpp"

namespace riffle::inline case_file {

SectionKeys bed_patch_keys() {
    using enum Dimension;
    SectionKeys s{"bed_patch",
                  "A part of the bed, a strip or a rectangle, that is rough in another way than [bed]; any "
                  "number side by side, each under [[bed_patch]].",
                  {},
                  [](const Case& c) { return c.bed_patches.size(); }};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("bed_patch", name, &Case::bed_patches, member, meaning);
    };
    const std::vector<std::string> spheres = beds_where([](const BedTraits& t) { return t.spheres; });
    const std::vector<std::string> roughness = beds_where([](const BedTraits& t) { return t.roughness; });
    s.keys.push_back(key("name", &BedPatch::name, "Name of the patch, for messages and figures.")
                         .is_required()
                         .with_example("\"cobbles\""));
    s.keys.push_back(key("kind", &BedPatch::kind, "Kind of the bed there."));
    s.keys.push_back(key("equivalent_roughness", &BedPatch::equivalent_roughness,
                         "Equivalent sand roughness k_s (Nikuradse) of a patch by roughness.")
                         .measured_in(length)
                         .greater_than(0)
                         .unset_by("none", "from `manning`")
                         .with_example("\"30 mm\"")
                         .applies_with("bed_patch.kind", roughness, true));
    s.keys.push_back(
        key("manning", &BedPatch::manning,
            "Manning's n of the uniform flow over such a bed at the depth of the case, s/m^(1/3).")
            .at_least(0.001)
            .at_most(1)
            .because("glass has 0.009, floodplains with trees 0.2")
            .unset_by("none", "from `equivalent_roughness`")
            .with_example("0.03")
            .applies_with("bed_patch.kind", roughness, true));
    s.keys.push_back(key("sphere_diameter", &BedPatch::sphere_diameter, "Diameter D of its spheres.")
                         .measured_in(length)
                         .greater_than(0)
                         .applies_with("bed_patch.kind", spheres));
    s.keys.push_back(
        key("roughness_height", &BedPatch::roughness_height,
            "Height of the crests of its spheres above the bed level z = 0, which is that of the "
            "whole channel; a plane patch lies at the bed level.")
            .measured_in(length)
            .greater_than(0)
            .unset_by("none", "required for spheres")
            .with_example("\"10 mm\"")
            .applies_with("bed_patch.kind", spheres, true));
    s.keys.push_back(key("packing", &BedPatch::packing, "Arrangement of its spheres, seen from above.")
                         .applies_with("bed_patch.kind", spheres));
    s.keys.push_back(
        key("drag_coefficient", &BedPatch::drag_coefficient, "Drag coefficient C_d of its spheres.")
            .at_least(0)
            .at_most(10)
            .because("bluff bodies have 0.3 to 2")
            .applies_with("bed_patch.kind", spheres));
    add_range_keys(s, &Case::bed_patches);
    return s;
}

}  // namespace riffle::inline case_file
