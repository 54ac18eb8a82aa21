#include "case/solid_keys.hpp"

#include <utility>

#include "case/motion_keys.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

/// A key of [[solid]].
template <class T>
Key solid_key(const char* name, T Solid::*member, const char* meaning) {
    return make_key("solid", name, &Case::solids, member, meaning);
}

/// Of solids by their shape.
void add_shape_keys(SectionKeys& s) {
    using enum Dimension;
    const std::string shape = "solid.shape";
    s.keys.push_back(
        solid_key("centre", &Solid::centre, "Its centre: x, y and z in three dimensions, x and z in two.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("required for these shapes")
            .with_example(R"(["100 mm", "50 mm", "20 mm"])")
            .applies_with(shape, {"box", "sphere", "cylinder", "rectangle", "circle"}, true));
    s.keys.push_back(
        solid_key("size", &Solid::size, "Its lengths along x, y and z, of a rectangle along x and z.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("required for these shapes")
            .with_example(R"(["40 mm", "20 mm", "20 mm"])")
            .applies_with(shape, {"box", "rectangle"}, true));
    s.keys.push_back(
        solid_key("angle", &Solid::angle,
                  "Degrees by which it is turned against the clock: a box about its upright axis, "
                  "seen from above; a rectangle about its centre, x to the right and z upward.")
            .at_least(-360)
            .at_most(360)
            .applies_with(shape, {"box", "rectangle"}, true));
    s.keys.push_back(solid_key("diameter", &Solid::diameter, "Its diameter; that of each of the spheres.")
                         .measured_in(length)
                         .at_least(0)
                         .with_default_note("required for these shapes")
                         .with_example(R"("20 mm")")
                         .applies_with(shape, {"sphere", "cylinder", "circle", "pipe", "spheres"}, true));
    s.keys.push_back(solid_key("length", &Solid::length, "Length of a cylinder.")
                         .measured_in(length)
                         .at_least(0)
                         .with_default_note("required for a cylinder")
                         .with_example(R"("80 mm")")
                         .applies_with(shape, {"cylinder"}, true));
    s.keys.push_back(solid_key("axis", &Solid::axis, "Direction of a cylinder's axis.")
                         .applies_with(shape, {"cylinder"}, true));
    s.keys.push_back(
        solid_key("y", &Solid::y,
                  "Places across the channel of the corners of a cross-section, from one side to "
                  "the other. Two at one place make an upright step.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("required for a section")
            .with_example(R"(["0 mm", "80 mm", "100 mm", "200 mm"])")
            .applies_with(shape, {"section"}, true));
    s.keys.push_back(solid_key("levels", &Solid::levels, "Heights of the same corners above the bed level.")
                         .measured_in(length)
                         .may_be_empty()
                         .with_default_note("required for a section")
                         .with_example(R"(["40 mm", "40 mm", "0 mm", "0 mm"])")
                         .applies_with(shape, {"section"}, true));
    s.keys.push_back(
        solid_key(
            "bottom_width", &Solid::bottom_width,
            "Width of the bottom of a trapezoid, or of the main channel of a compound one; 0: a triangle.")
            .measured_in(length)
            .at_least(0)
            .with_example(R"("300 mm")")
            .applies_with(shape, {"trapezoid", "compound"}, true));
    s.keys.push_back(
        solid_key("bank_slope", &Solid::bank_slope, "Horizontal over vertical of the banks; 0: upright ones.")
            .at_least(0)
            .at_most(100)
            .with_example("1.5")
            .applies_with(shape, {"trapezoid", "compound"}, true));
    s.keys.push_back(
        solid_key("bank_height", &Solid::bank_height,
                  "Height of the banks above the bottom; beyond them it is level up to the sides, or the "
                  "floodplains of a compound channel begin.")
            .measured_in(length)
            .at_least(0)
            .unset_by("auto", "the banks reach up to the sides; a compound channel needs it")
            .with_example(R"("80 mm")")
            .applies_with(shape, {"trapezoid", "compound"}, true));
    s.keys.push_back(solid_key("floodplain_width", &Solid::floodplain_width,
                               "Width of each of the floodplains, beyond which banks of the same slope rise.")
                         .measured_in(length)
                         .at_least(0)
                         .unset_by("auto", "up to the sides")
                         .with_example(R"("200 mm")")
                         .applies_with(shape, {"compound"}, true));
    s.keys.push_back(solid_key("packing", &Solid::packing, "How the spheres lie, seen from above.")
                         .applies_with(shape, {"spheres"}, true));
    s.keys.push_back(solid_key("level", &Solid::level, "Height of the spheres' centres above the bed level.")
                         .measured_in(length)
                         .unset_by("auto", "half the diameter: they lie on the bed")
                         .applies_with(shape, {"spheres"}, true));
    s.keys.push_back(
        solid_key("smaller_diameters", &Solid::smaller_diameters,
                  "Diameters of further spheres among those of `diameter`, the largest, in random places.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("none: all are equal")
            .with_example(R"(["16 mm", "8 mm"])")
            .applies_with(shape, {"spheres"}, true));
    s.keys.push_back(
        solid_key(
            "area_shares", &Solid::area_shares,
            "Shares of the plan, seen from above, that the spheres of each size cover, from the largest "
            "on; the smallest lie where chance leaves them room.")
            .at_least(0)
            .at_most(0.5)
            .because("spheres in random places cover hardly more than half of the plan")
            .may_be_empty()
            .with_default_note("0.45 in equal parts")
            .with_example("[0.2, 0.15]")
            .applies_with(shape, {"spheres"}, true));
    s.keys.push_back(solid_key("seed", &Solid::seed, "Seed of the random places of spheres.")
                         .at_least(0)
                         .at_most(1e9)
                         .applies_with(shape, {"spheres"}, true));
}

/// Of beds from measured heights.
void add_bed_keys(SectionKeys& s) {
    using enum Dimension;
    const std::string shape = "solid.shape";
    s.keys.push_back(
        solid_key(
            "heights", &Solid::heights,
            "File of the heights of a bed: an ESRI ASCII grid (.asc), a GeoTIFF (.tif), or lines of x, y and z "
            "on a regular grid (.csv, .xyz, .txt); in two dimensions of x and z.")
            .with_default_note("required for a bed")
            .with_example(R"("gravel.asc")")
            .applies_with(shape, {"bed"}, true));
    s.keys.push_back(solid_key("unit", &Solid::unit, "Length of the unit of that file.")
                         .measured_in(length)
                         .greater_than(0)
                         .applies_with(shape, {"bed"}, true));
    s.keys.push_back(solid_key("height_unit", &Solid::height_unit, "Length of the unit of its heights.")
                         .measured_in(length)
                         .greater_than(0)
                         .unset_by("auto", "as `unit`")
                         .applies_with(shape, {"bed"}, true));
    s.keys.push_back(
        solid_key("origin", &Solid::origin,
                  "Place in that file, in its units, that comes to x = 0, y = 0 and the bed level "
                  "z = 0 of the channel: three numbers, in two dimensions x and z.")
            .at_least(-1e9)
            .at_most(1e9)
            .because("maps of the earth go to 1e7 m")
            .may_be_empty()
            .with_default_note("the file's own origin")
            .with_example("[523400, 4512300, 118.2]")
            .applies_with(shape, {"bed"}, true));
    s.keys.push_back(
        solid_key("blend", &Solid::blend,
                  "Length before periodic ends and sides over which the difference of the bed's "
                  "heights between the two is spread; beside open ends, where the bed is made the "
                  "same along the channel, that over which it goes over to the heights of the file "
                  "(0: as far again as it is the same).")
            .measured_in(length)
            .at_least(0)
            .applies_with(shape, {"bed"}, true));
    s.keys.push_back(
        solid_key("largest_hole", &Solid::largest_hole,
                  "Width of the widest hole without heights that is filled; a wider one is refused.")
            .measured_in(length)
            .at_least(0)
            .unset_by("auto", "four particle spacings")
            .applies_with(shape, {"bed"}, true));
}

}  // namespace

SectionKeys solid_keys() {
    using enum Dimension;
    SectionKeys s{"solid",
                  "A body that the water flows around; any number of them, each under [[solid]].",
                  {},
                  [](const Case& c) { return c.solids.size(); }};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("solid", name, &Case::solids, member, meaning);
    };
    const std::string shape = "solid.shape";
    s.keys.push_back(key("name", &Solid::name, "Name of the solid, for messages.")
                         .is_required()
                         .with_example(R"("weir")"));
    s.keys.push_back(key("shape", &Solid::shape, "What it is, and by which keys it is described."));
    s.keys.push_back(
        key("x", &Solid::x, "Corners of its outline along the channel, one after the other in either sense.")
            .measured_in(length)
            .with_default_note("required in two dimensions")
            .with_example(R"(["100 mm", "140 mm", "140 mm", "100 mm"])")
            .applies_with(shape, {"free-form"}, true)
            .and_with("channel.dimensions", {"2"}));
    s.keys.push_back(key("z", &Solid::z, "Heights of the same corners above the bed level.")
                         .measured_in(length)
                         .with_default_note("required in two dimensions")
                         .with_example(R"(["0 mm", "0 mm", "20 mm", "20 mm"])")
                         .applies_with(shape, {"free-form"}, true)
                         .and_with("channel.dimensions", {"2"}));
    s.keys.push_back(key("file", &Solid::file,
                         "File of its closed surface in three dimensions: STL, OBJ or PLY, by its ending.")
                         .with_default_note("required in three dimensions")
                         .with_example(R"("stone.stl")")
                         .applies_with(shape, {"free-form"}, true)
                         .and_with("channel.dimensions", {"3"}));
    s.keys.push_back(key("scale", &Solid::scale, "Length of the file's unit.")
                         .measured_in(length)
                         .greater_than(0)
                         .applies_with(shape, {"free-form"}, true)
                         .and_with("channel.dimensions", {"3"}));
    s.keys.push_back(key("place", &Solid::place, "x, y and z of the file's origin in the channel.")
                         .measured_in(length)
                         .may_be_empty()
                         .with_default_note("the channel's origin")
                         .with_example(R"(["100 mm", "50 mm", "0 mm"])")
                         .applies_with(shape, {"free-form"}, true)
                         .and_with("channel.dimensions", {"3"}));
    add_shape_keys(s);
    add_bed_keys(s);
    s.keys.push_back(key("surface", &Solid::surface, "What the water does at it."));
    s.keys.push_back(key("equivalent_roughness", &Solid::equivalent_roughness,
                         "Equivalent sand roughness k_s of its surface; 0: smooth.")
                         .measured_in(length)
                         .at_least(0)
                         .with_example(R"("2 mm")")
                         .applies_with("solid.surface", {"log-law"}, true));
    s.keys.push_back(key("manning", &Solid::manning,
                         "Manning's n of its surface, that of uniform flow at the depth of the case, "
                         "s/m^(1/3), in place of `equivalent_roughness`.")
                         .at_least(0.001)
                         .at_most(1)
                         .because("glass has 0.009, floodplains with trees 0.2")
                         .unset_by("none", "from `equivalent_roughness`")
                         .with_example("0.015")
                         .applies_with("solid.surface", {"log-law"}, true));
    s.keys.push_back(
        key("part_of_bed", &Solid::part_of_bed,
            "Whether it belongs to the bed: the flow over it is that over a rough bed, whose crests and "
            "datum are those of `[bed]`, and not one around a body."));
    s.keys.push_back(
        key("moment_about", &Solid::moment_about,
            "Point that the moments of the forces on it are about, where it is at t = 0: x, y and z in three "
            "dimensions, x and z in two. It moves with the solid.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("the solid's centroid")
            .with_example(R"(["120 mm", "0 mm"])"));
    s.keys.push_back(key("motion", &Solid::motion, "Whether and how it moves."));
    add_motion_keys(s);
    add_free_body_keys(s);
    return s;
}

}  // namespace riffle::inline case_file
