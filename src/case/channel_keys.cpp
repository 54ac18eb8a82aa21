#include "case/channel_keys.hpp"

#include <utility>

#include "case/bed_traits.hpp"
#include "case/closure_traits.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

using enum Dimension;

SectionKeys heading() {
    SectionKeys s{"", "Before the first section.", {}};
    s.keys.push_back(make_key("title", &Case::title, "Title of the run, for reports."));
    s.keys.push_back(make_key("description", &Case::description, "What the case is about, in any length.")
                         .may_have_several_lines());
    return s;
}

SectionKeys channel() {
    SectionKeys s{"channel", "The channel and the depth of the water.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("channel", name, &Case::channel, member, meaning);
    };
    s.keys.push_back(key("slope", &Channel::slope, "Bed slope S0 = tan(theta).")
                         .at_least(0)
                         .at_most(1)
                         .because("steeper than 45 degrees the water leaves the bed")
                         .is_required()
                         .with_example("0.004"));
    s.keys.push_back(key("depth", &Channel::depth,
                         "Water depth h_w over the zero datum (`bed.datum_below_crest` below the crests; the "
                         "bed where smooth).")
                         .measured_in(length)
                         .greater_than(0)
                         .is_required()
                         .with_example("\"50 mm\""));
    s.keys.push_back(key("length", &Channel::length, "Length of the simulated reach along the bed.")
                         .measured_in(length)
                         .greater_than(0));
    s.keys.push_back(
        key("width", &Channel::width, "Width of the flume; in 3D with periodic sides the simulated width.")
            .measured_in(length)
            .greater_than(0));
    s.keys.push_back(key("dimensions", &Channel::dimensions,
                         "2: a plane along the channel; 3: with the direction y across it.")
                         .at_least(2)
                         .at_most(3));
    s.keys.push_back(key("ends", &Channel::ends, "What the two ends of the reach are."));
    s.keys.push_back(key("sides", &Channel::sides, "What the water ends at across the channel.")
                         .applies_with("channel.dimensions", {"3"}, true));
    s.keys.push_back(key("top", &Channel::top, "What the water ends at above."));
    s.keys.push_back(
        key("wall_height", &Channel::wall_height, "Height of the upright end walls above the bed level.")
            .measured_in(length)
            .greater_than(0)
            .unset_by("auto", "one and a half times the total depth; up to a wall at the top")
            .applies_with("channel.ends", {"walls"}, true));
    s.keys.push_back(
        key("lid_velocity", &Channel::lid_velocity, "Velocity of the wall at the top, along the channel.")
            .measured_in(velocity)
            .applies_with("channel.top", {"wall"}, true));
    return s;
}

SectionKeys bed() {
    SectionKeys s{"bed", "The bed and its roughness.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("bed", name, &Case::bed, member, meaning);
    };
    const std::vector<std::string> spheres = beds_where([](const BedTraits& t) { return t.spheres; });
    const std::vector<std::string> roughness = beds_where([](const BedTraits& t) { return t.roughness; });
    const char* const plane = "0 for a plane bed";
    s.keys.push_back(key("kind", &Bed::kind, "Kind of the bed."));
    s.keys.push_back(key("sphere_diameter", &Bed::sphere_diameter, "Diameter D of the bed's spheres.")
                         .measured_in(length)
                         .greater_than(0)
                         .applies_with("bed.kind", spheres));
    s.keys.push_back(key("packing", &Bed::packing, "Arrangement of the spheres, seen from above.")
                         .applies_with("bed.drag_form", {"consistent", "slice", "thesis", "plan-mean"}));
    s.keys.push_back(
        key("roughness_height", &Bed::roughness_height,
            "Thickness d_h of the roughness zone, from the bed level z = 0 up to the crests; a length "
            "or a multiple of D.")
            .measured_in(length)
            .at_least(0)
            .may_be_diameters()
            .with_default_note(
                std::string("required for spheres; the highest point of the solids that are part of "
                            "the bed; ") +
                plane)
            .with_example("\"0.4 D\""));
    s.keys.push_back(key("datum_below_crest", &Bed::datum_below_crest,
                         "Distance of the zero datum, from which the depth is measured, below the crests.")
                         .measured_in(length)
                         .at_least(0)
                         .with_default_note(std::string("4 mm for spheres; else 0")));
    s.keys.push_back(key("drag_coefficient", &Bed::drag_coefficient, "Drag coefficient C_d of the spheres.")
                         .at_least(0)
                         .at_most(10)
                         .because("bluff bodies have 0.3 to 2")
                         .applies_with("bed.kind", spheres));
    s.keys.push_back(key("drag_form", &Bed::drag_form, "How the drag enters the momentum equation.")
                         .applies_with("bed.kind", spheres));
    s.keys.push_back(
        key("sphere_ramp", &Bed::sphere_ramp,
            "Length over which the drag of a sphere sets in around its surface (the shape factor phi).")
            .measured_in(length)
            .greater_than(0)
            .unset_by("auto", "a tenth of the diameter; the spacing with `drag_form = \"thesis\"`")
            .applies_with("channel.dimensions", {"3"}, true));
    s.keys.push_back(key("equivalent_roughness", &Bed::equivalent_roughness,
                         "Equivalent sand roughness k_s (Nikuradse) of a bed by roughness.")
                         .measured_in(length)
                         .greater_than(0)
                         .unset_by("none", "from `manning`")
                         .with_example("\"1 mm\"")
                         .applies_with("bed.kind", roughness, true));
    s.keys.push_back(
        key("manning", &Bed::manning,
            "Manning's n of the uniform flow at the depth of the case, s/m^(1/3), from which the "
            "roughness follows.")
            .at_least(0.001)
            .at_most(1)
            .because("glass has 0.009, floodplains with trees 0.2")
            .unset_by("none", "from `equivalent_roughness`")
            .with_example("0.02")
            .applies_with("bed.kind", roughness, true));
    return s;
}

SectionKeys side_walls() {
    SectionKeys s{"side_walls", "The walls beside the water, in three dimensions.", {}};
    s.keys.push_back(
        make_key("side_walls", "drag_form", &Case::side_walls, &SideWalls::drag_form,
                 "How the drag of the walls is found.")
            .with_default_note(
                "consistent over spheres; log-law over beds by roughness and smooth ones; none over others")
            .applies_with("channel.sides", {"walls", "half"}, true));
    s.keys.push_back(make_key("side_walls", "layer", &Case::side_walls, &SideWalls::layer,
                              "Thickness of the layer of water in which the drag of a wall acts.")
                         .measured_in(length)
                         .greater_than(0)
                         .unset_by("auto", "the roughness height; three spacings over a bed without")
                         .applies_with("channel.sides", {"walls", "half"}, true));
    s.keys.push_back(make_key("side_walls", "equivalent_roughness", &Case::side_walls,
                              &SideWalls::equivalent_roughness,
                              "Equivalent sand roughness k_s of the walls; 0: smooth walls.")
                         .measured_in(length)
                         .at_least(0)
                         .unset_by("auto", "that of a bed by roughness, else smooth")
                         .with_example("0.5 mm")
                         .applies_with("side_walls.drag_form", {"log-law"}, true));
    return s;
}

SectionKeys turbulence() {
    SectionKeys s{"turbulence", "The turbulence closure and its constants.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("turbulence", name, &Case::turbulence, member, meaning);
    };
    const std::string closure = "turbulence.closure";
    const std::vector<std::string> mixing_lengths =
        closures_where([](const ClosureTraits& t) { return t.family == ClosureFamily::mixing_length; });
    const std::vector<std::string> filters = closures_where([](const ClosureTraits& t) {
        return t.family == ClosureFamily::filter || t.family == ClosureFamily::resolved;
    });
    s.keys.push_back(key("closure", &Turbulence::closure, "Where the eddy viscosity comes from."));
    s.keys.push_back(
        key("kappa", &Turbulence::kappa, "Von Karman's constant.")
            .at_least(0.1)
            .at_most(1)
            .because("measured: 0.35 to 0.45")
            .applies_with(closure, closures_where([](const ClosureTraits& t) { return t.has_kappa; })));
    s.keys.push_back(key("lambda", &Turbulence::lambda, "Plateau of the ramp: l_m = lambda H.")
                         .at_least(0.001)
                         .at_most(1)
                         .because("measured: 0.07 to 0.14")
                         .applies_with(closure, {"ramp"}));
    s.keys.push_back(key("wake_strength", &Turbulence::wake_strength, "Coles' wake strength Pi.")
                         .at_least(0)
                         .at_most(2)
                         .because("measured: 0 to 0.6")
                         .unset_by("auto", "0.2 for czernuszenko-rylov, 0 for nezu-rodi")
                         .applies_with(closure, {"nezu-rodi", "czernuszenko-rylov"}));
    s.keys.push_back(
        key("zero", &Turbulence::zero,
            "Height above the bed level at which the mixing length starts from zero.")
            .measured_in(length)
            .at_least(0)
            .applies_with(closure, closures_where([](const ClosureTraits& t) { return t.has_zero; })));
    s.keys.push_back(key("smagorinsky_constant", &Turbulence::smagorinsky_constant, "Constant C_s.")
                         .greater_than(0)
                         .at_most(10)
                         .because("used: 0.06 to 0.2")
                         .applies_with(closure, filters));
    s.keys.push_back(key("filter_width", &Turbulence::filter_width, "Filter width Delta.")
                         .measured_in(length)
                         .greater_than(0)
                         .unset_by("auto", "spacing / sqrt(2) for sps, the spacing for resolved eddies")
                         .applies_with(closure, filters));
    s.keys.push_back(
        key("stress_terms", &Turbulence::stress_terms, "What is kept of the strain rate and the stress.")
            .applies_with(closure, closures_where([](const ClosureTraits& t) { return t.parts_stress; })));
    s.keys.push_back(
        key("eddy_rate", &Turbulence::eddy_rate,
            "Which rate of the flow times the square of the mixing length is the eddy viscosity.")
            .applies_with(closure,
                          closures_where([](const ClosureTraits& t) { return t.by_velocity_rate; })));
    s.keys.push_back(key("depth", &Turbulence::depth, "Which depth of the water the mixing lengths follow.")
                         .applies_with(closure, mixing_lengths));
    s.keys.push_back(key("edge_zone", &Turbulence::edge_zone,
                         "gamma: beside each wall the mixing lengths grow over a zone of gamma H / 2.")
                         .at_least(0.01)
                         .at_most(10)
                         .because("its source has 0.25 to 1")
                         .applies_with(closure, {"czernuszenko-rylov"}));
    s.keys.push_back(key("spanwise_ratio", &Turbulence::spanwise_ratio,
                         "Ratio of the mixing lengths across and along the channel, l_y / l_x.")
                         .at_least(0.01)
                         .at_most(1)
                         .because("its source has 0.5")
                         .applies_with(closure, {"czernuszenko-rylov"}));
    return s;
}

SectionKeys fluid() {
    SectionKeys s{"fluid", "The water.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("fluid", name, &Case::fluid, member, meaning);
    };
    s.keys.push_back(key("density", &Fluid::density, "Density rho0.").measured_in(density).greater_than(0));
    s.keys.push_back(key("kinematic_viscosity", &Fluid::kinematic_viscosity, "Molecular viscosity nu0.")
                         .measured_in(kinematic_viscosity)
                         .at_least(0));
    s.keys.push_back(
        key("gravity", &Fluid::gravity, "Acceleration of gravity g.").measured_in(acceleration).at_least(0));
    return s;
}

}  // namespace

std::vector<SectionKeys> channel_keys() {
    return {heading(), channel(), bed(), side_walls(), turbulence(), fluid()};
}

}  // namespace riffle::inline case_file
