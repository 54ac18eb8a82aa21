#include "case/vegetation_keys.hpp"

#include <utility>

#include "case/patch_keys.hpp"

namespace riffle::inline case_file {

SectionKeys vegetation_keys() {
    using enum Dimension;
    SectionKeys s{"vegetation",
                  "Stems that stand in the water and hold it back; any number of patches side by side, each "
                  "under [[vegetation]].",
                  {},
                  [](const Case& c) { return c.vegetation.size(); }};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("vegetation", name, &Case::vegetation, member, meaning);
    };
    s.keys.push_back(key("name", &Vegetation::name, "Name of the patch, for messages and figures.")
                         .is_required()
                         .with_example("\"reeds\""));
    s.keys.push_back(key("stems_per_area", &Vegetation::stems_per_area, "Stems on an area of the bed, n.")
                         .measured_in(number_per_area)
                         .greater_than(0)
                         .is_required()
                         .with_example("\"400 1/m2\""));
    s.keys.push_back(key("stem_diameter", &Vegetation::stem_diameter, "Diameter of the stems, d.")
                         .measured_in(length)
                         .greater_than(0)
                         .is_required()
                         .with_example("\"6 mm\""));
    s.keys.push_back(key("height", &Vegetation::height,
                         "Height of the tops of the stems above the bed level, or above what they stand on; "
                         "above the surface the stems are emergent.")
                         .measured_in(length)
                         .greater_than(0)
                         .is_required()
                         .with_example("\"60 mm\""));
    s.keys.push_back(key("stands_on", &Vegetation::stands_on,
                         "Name of the solid at rest on whose top the stems stand, a beach, a bank or a bed "
                         "of measured heights; beside it they stand on the bed.")
                         .with_default_note("none: they stand on the bed")
                         .with_example("\"bank\""));
    s.keys.push_back(
        key("drag_coefficient", &Vegetation::drag_coefficient,
            "C_D of the stems, with the velocity of the water between them and their frontal area.")
            .greater_than(0)
            .at_most(100)
            .because("a cylinder has about 1, at Reynolds numbers of some units 10")
            .unset_by("cheng-nguyen",
                      "that of rigid cylinders by the Reynolds number of the vegetation-related hydraulic "
                      "radius (Cheng & Nguyen 2011)"));
    s.keys.push_back(
        key("vogel_exponent", &Vegetation::vogel_exponent,
            "psi of flexible stems, whose force grows with U^(2 + psi) above the reference velocity; 0: "
            "rigid.")
            .greater_than(-2)
            .at_most(0)
            .because("plants in water have -0.2 to -1.2, and a force must not fall as the velocity rises"));
    s.keys.push_back(key("reference_velocity", &Vegetation::reference_velocity,
                         "Velocity up to which flexible stems stand as rigid ones.")
                         .measured_in(velocity)
                         .greater_than(0)
                         .unset_by("none", "the stems are rigid"));
    add_range_keys(s, &Case::vegetation);
    return s;
}

}  // namespace riffle::inline case_file
