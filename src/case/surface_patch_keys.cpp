#include "case/surface_patch_keys.hpp"

#include "case/patch_keys.hpp"

namespace riffle::inline case_file {

SectionKeys surface_patch_keys() {
    SectionKeys s{
        "surface_patch",
        "A part of a solid by the log law, a canal or a bed from data say, that is rough in another way "
        "than the rest of it: all of its surface in a range or an outline in plan; any number side by "
        "side, each under [[surface_patch]].",
        {},
        [](const Case& c) { return c.surface_patches.size(); }};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("surface_patch", name, &Case::surface_patches, member, meaning);
    };
    s.keys.push_back(key("name", &SurfacePatch::name, "Name of the patch, for messages and figures.")
                         .is_required()
                         .with_example("\"floodplain\""));
    s.keys.push_back(key("solid", &SurfacePatch::solid,
                         "Name of the [[solid]] with `surface = \"log-law\"` that it is a part of.")
                         .is_required()
                         .with_example("\"canal\""));
    s.keys.push_back(key("equivalent_roughness", &SurfacePatch::equivalent_roughness,
                         "Equivalent sand roughness k_s (Nikuradse) of the surface there; 0: smooth.")
                         .measured_in(Dimension::length)
                         .at_least(0)
                         .unset_by("none", "from `manning`")
                         .with_example("\"20 mm\""));
    s.keys.push_back(key("manning", &SurfacePatch::manning,
                         "Manning's n of the surface there, that of uniform flow at the depth of the case, "
                         "s/m^(1/3).")
                         .at_least(0.001)
                         .at_most(1)
                         .because("glass has 0.009, floodplains with trees 0.2")
                         .unset_by("none", "from `equivalent_roughness`")
                         .with_example("0.03"));
    add_range_keys(s, &Case::surface_patches);
    return s;
}

}  // namespace riffle::inline case_file
