#include "case/porous_keys.hpp"

#include <utility>

#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

/// A key of [[porous]].
template <class T>
Key porous_key(const char* name, T Porous::*member, const char* meaning) {
    return make_key("porous", name, &Case::porous, member, meaning);
}

/// What the medium is made of.
void add_medium_keys(SectionKeys& s) {
    using enum Dimension;
    s.keys.push_back(porous_key("porosity", &Porous::porosity,
                                "Porosity n: the share of the volume of the medium that water fills.")
                         .greater_than(0)
                         .at_most(1)
                         .is_required()
                         .with_example("0.4"));
    s.keys.push_back(
        porous_key(
            "grain_size", &Porous::grain_size,
            "Diameter d of the grains, from which the resistance follows, a pressure gradient over the density of "
            "A (1 - n)^2 nu q/(n^3 d^2) + B (1 - n) |q| q/(n^3 d), q the discharge of an area (Ergun 1952).")
            .measured_in(length)
            .greater_than(0)
            .unset_by("none", "the medium is given by its permeability"));
    s.keys.push_back(
        porous_key("laminar_coefficient", &Porous::laminar_coefficient, "A of this law; Ergun's is 150.")
            .at_least(0)
            .at_most(1e5)
            .because("laboratories find 150 to some 1000"));
    s.keys.push_back(
        porous_key("inertial_coefficient", &Porous::inertial_coefficient, "B of this law; Ergun's is 1.75.")
            .at_least(0)
            .at_most(100)
            .because("laboratories find 0.4 to 4"));
    s.keys.push_back(porous_key("permeability", &Porous::permeability,
                                "Permeability K in place of the grain size: the resistance is nu q/K.")
                         .measured_in(area)
                         .greater_than(0)
                         .unset_by("none", "the resistance follows from the grain size"));
    s.keys.push_back(porous_key("forchheimer", &Porous::forchheimer,
                                "c_F of a resistance c_F |q| q/sqrt(K) beside that of the permeability.")
                         .at_least(0)
                         .at_most(100)
                         .because("media of grains have about 0.5"));
    s.keys.push_back(
        porous_key("viscosity_ratio", &Porous::viscosity_ratio,
                   "Shear stress in the medium over rho nu dq/dz, per area of the whole (Brinkman 1949).")
            .at_least(0)
            .at_most(100)
            .because("1 is that of the averaged equations, measurements find 0.1 to 10"));
    s.keys.push_back(
        porous_key("mixing_length", &Porous::mixing_length, "Largest mixing length of eddies in the pores.")
            .measured_in(length)
            .at_least(0)
            .unset_by("auto", "a tenth of the grain size, or 3 sqrt(K)"));
}

/// Where it is.
void add_place_keys(SectionKeys& s) {
    using enum Dimension;
    const auto bound = [](const char* name, auto member, const char* meaning, const char* otherwise) {
        return porous_key(name, member, meaning).measured_in(length).unset_by("auto", otherwise);
    };
    const auto across = [](Key&& key) {
        return std::move(key).applies_with("channel.dimensions", {"3"}, true);
    };
    s.keys.push_back(
        bound("x_from", &Porous::x_from, "Where the zone begins along the channel.", "at its start"));
    s.keys.push_back(bound("x_to", &Porous::x_to, "Where it ends along the channel.", "at its end"));
    s.keys.push_back(
        across(bound("y_from", &Porous::y_from, "Where it begins across a three-dimensional channel.",
                     "at its side, y = 0")));
    s.keys.push_back(
        across(bound("y_to", &Porous::y_to, "Where it ends across the channel.", "at the other side")));
    s.keys.push_back(bound("z_from", &Porous::z_from, "Height of its bottom above the bed level.",
                           "it stands on the bed"));
    s.keys.push_back(
        bound("z_to", &Porous::z_to, "Height of its top above the bed level.", "it reaches above all water"));
    s.keys.push_back(
        porous_key(
            "x", &Porous::x,
            "Places along the channel of the corners of the zone's outline, in either sense of rotation: seen from the "
            "side with `z`, in place of x_from, x_to, z_from and z_to (in three dimensions it is the same across the "
            "channel); in three dimensions, in plan with `y`, in place of x_from, x_to, y_from and y_to.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("a box")
            .with_example(R"(["100 mm", "300 mm", "250 mm", "150 mm"])"));
    s.keys.push_back(
        across(porous_key("y", &Porous::y, "Places across a three-dimensional channel of the same corners.")
                   .measured_in(length)
                   .may_be_empty()
                   .with_default_note("no outline in plan")
                   .with_example(R"(["40 mm", "60 mm", "120 mm", "100 mm"])")));
    s.keys.push_back(porous_key("z", &Porous::z, "Heights of the same corners above the bed level.")
                         .measured_in(length)
                         .may_be_empty()
                         .with_default_note("a box")
                         .with_example(R"(["0 mm", "0 mm", "80 mm", "80 mm"])"));
    s.keys.push_back(
        porous_key(
            "top_x", &Porous::top_x,
            "Places along the channel, one after the other, of heights of the zone's top, in place of z_to.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("a level top")
            .with_example(R"(["0 mm", "200 mm", "400 mm"])"));
    s.keys.push_back(
        porous_key("top_z", &Porous::top_z,
                   "The heights above the bed level there; between them it runs straight, beyond them level.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("a level top")
            .with_example(R"(["20 mm", "35 mm", "25 mm"])"));
    s.keys.push_back(
        porous_key(
            "edge", &Porous::edge,
            "Thickness over which the porosity changes from that of the medium to 1, half of it on either side.")
            .measured_in(length)
            .greater_than(0)
            .unset_by("auto", "2.4 smoothing lengths, over which the kernel smooths a step"));
}

}  // namespace

SectionKeys porous_keys() {
    SectionKeys s{
        "porous",
        "A part of the channel that a porous medium fills: grains at rest, and water in their pores. Any "
        "number of zones beside each other, each under [[porous]].",
        {},
        [](const Case& c) { return c.porous.size(); }};
    s.keys.push_back(porous_key("name", &Porous::name, "Name of the zone, for messages and figures.")
                         .is_required()
                         .with_example("\"gravel\""));
    add_medium_keys(s);
    add_place_keys(s);
    return s;
}

}  // namespace riffle::inline case_file
