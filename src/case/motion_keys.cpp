#include "case/motion_keys.hpp"

#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

const char* const motion = "solid.motion";

/// A key of [[solid]].
template <class T>
Key solid_key(const char* name, T Solid::*member, const char* meaning) {
    return make_key("solid", name, &Case::solids, member, meaning);
}

void add_velocity(SectionKeys& s, const char* name, double Solid::*member, const char* meaning) {
    s.keys.push_back(solid_key(name, member, meaning)
                         .measured_in(Dimension::velocity)
                         .applies_with(motion, {"constant", "free"}, true));
}

void add_amplitude(SectionKeys& s, const char* name, double Solid::*member, const char* meaning) {
    s.keys.push_back(solid_key(name, member, meaning)
                         .measured_in(Dimension::length)
                         .applies_with(motion, {"oscillating"}, true));
}

void add_table(SectionKeys& s) {
    using enum Dimension;
    s.keys.push_back(solid_key("times", &Solid::times, "Times of a table of its motion, from its start on.")
                         .measured_in(time)
                         .may_be_empty()
                         .with_default_note("required for a table")
                         .with_example(R"(["0 s", "0.5 s", "1 s"])")
                         .applies_with(motion, {"table"}, true));
    const auto shifts = [&](const char* name, std::vector<double> Solid::*member, const char* meaning) {
        s.keys.push_back(solid_key(name, member, meaning)
                             .measured_in(length)
                             .may_be_empty()
                             .with_default_note("none")
                             .with_example(R"(["0 mm", "20 mm", "0 mm"])")
                             .applies_with(motion, {"table"}, true));
    };
    shifts("shifts_x", &Solid::shifts_x,
           "How far it stands along the channel from its place at those times.");
    shifts("shifts_y", &Solid::shifts_y, "The same across the channel, in three dimensions.");
    shifts("shifts_z", &Solid::shifts_z, "The same upward.");
    s.keys.push_back(
        solid_key("angles", &Solid::angles, "Degrees by which it is turned about its axis at those times.")
            .at_least(-1e5)
            .at_most(1e5)
            .may_be_empty()
            .with_default_note("none")
            .with_example("[0, 90, 0]")
            .applies_with(motion, {"table"}, true));
}

void add_rotation(SectionKeys& s) {
    using enum Dimension;
    const char* const turning =
        "Radians per second at which it turns about its axis; of a free body at its start. In two dimensions "
        "a positive one turns z towards x, with the clock where x points to the right.";
    s.keys.push_back(solid_key("angular_velocity", &Solid::angular_velocity, turning)
                         .at_least(-1e5)
                         .at_most(1e5)
                         .applies_with(motion, {"constant", "free"}, true));
    s.keys.push_back(
        solid_key("amplitude_angle", &Solid::amplitude_angle, "Degrees by which it swings about its axis.")
            .at_least(-360)
            .at_most(360)
            .applies_with(motion, {"oscillating"}, true));
    s.keys.push_back(solid_key("rotation_axis", &Solid::rotation_axis,
                               "Direction of the axis that it turns about, in three dimensions, against the "
                               "clock for who looks against it.")
                         .at_least(-1e6)
                         .at_most(1e6)
                         .may_be_empty()
                         .with_default_note("that of y")
                         .with_example("[0, 0, 1]")
                         .applies_with(motion, {"constant", "oscillating", "table", "free"}, true));
    s.keys.push_back(
        solid_key("rotation_about", &Solid::rotation_about,
                  "Point of the axis at t = 0: x, y and z in three dimensions, x and z in two. It moves with "
                  "the solid.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("the solid's centroid")
            .with_example(R"(["120 mm", "0 mm"])")
            .applies_with(motion, {"constant", "oscillating", "table"}, true));
}

void add_freedom(SectionKeys& s, const char* name, bool Solid::*member, const char* meaning) {
    s.keys.push_back(solid_key(name, member, meaning).applies_with(motion, {"free"}, true));
}

void add_spring(SectionKeys& s, const char* name, double Solid::*member, const char* meaning) {
    s.keys.push_back(
        solid_key(name, member, meaning).at_least(0).at_most(1e12).applies_with(motion, {"free"}, true));
}

}  // namespace

void add_motion_keys(SectionKeys& s) {
    using enum Dimension;
    s.keys.push_back(solid_key("start", &Solid::start, "Simulated time at which it starts to move.")
                         .measured_in(time)
                         .at_least(0)
                         .applies_with(motion, {"constant", "oscillating", "table", "free"}, true));
    s.keys.push_back(solid_key("stop", &Solid::stop, "Simulated time at which it stops, for good.")
                         .measured_in(time)
                         .at_least(0)
                         .unset_by("never", "it moves to the end of the run")
                         .applies_with(motion, {"constant", "oscillating"}, true));
    add_velocity(s, "velocity_x", &Solid::velocity_x,
                 "Its velocity along the channel; of a free body at its start.");
    add_velocity(s, "velocity_y", &Solid::velocity_y,
                 "Its velocity across the channel, in three dimensions; of a free body at its start.");
    add_velocity(s, "velocity_z", &Solid::velocity_z, "Its velocity upward; of a free body at its start.");
    add_amplitude(s, "amplitude_x", &Solid::amplitude_x, "Amplitude of its swing along the channel.");
    add_amplitude(s, "amplitude_y", &Solid::amplitude_y,
                  "Amplitude of its swing across the channel, in three dimensions.");
    add_amplitude(s, "amplitude_z", &Solid::amplitude_z, "Amplitude of its swing upward.");
    s.keys.push_back(solid_key("frequency", &Solid::frequency, "Swings per time.")
                         .measured_in(frequency)
                         .at_least(0)
                         .applies_with(motion, {"oscillating"}, true));
    add_table(s);
    add_rotation(s);
}

void add_free_body_keys(SectionKeys& s) {
    using enum Dimension;
    s.keys.push_back(solid_key("density", &Solid::density, "Density of a free body.")
                         .measured_in(density)
                         .at_least(5)
                         .because("expanded foam has 10 kg/m3; 0.6 g/cm3 is density = \"0.6 g/cm3\"")
                         .unset_by("auto", "from its mass")
                         .with_example("700")
                         .applies_with(motion, {"free"}, true));
    s.keys.push_back(
        solid_key("mass", &Solid::mass,
                  "Mass of a free body, kg; in two dimensions per width, kg/m. Instead of its density.")
            .greater_than(0)
            .at_most(1e12)
            .unset_by("auto", "from its density")
            .with_example("0.35")
            .applies_with(motion, {"free"}, true));
    s.keys.push_back(
        solid_key("centre_of_mass", &Solid::centre_of_mass,
                  "Centre of mass of a free body at t = 0: x, y and z in three dimensions, x and "
                  "z in two.")
            .measured_in(length)
            .may_be_empty()
            .with_default_note("the solid's centroid")
            .with_example(R"(["120 mm", "80 mm"])")
            .applies_with(motion, {"free"}, true));
    s.keys.push_back(
        solid_key(
            "inertia", &Solid::inertia,
            "Moments of inertia of a free body about its centre of mass: about axes along x, y and z at "
            "t = 0, kg m2; in two dimensions one per width, kg m.")
            .greater_than(0)
            .at_most(1e15)
            .may_be_empty()
            .with_default_note("that of its mass evenly in its shape")
            .with_example("[2e-4, 3e-4, 3e-4]")
            .applies_with(motion, {"free"}, true));
    add_freedom(s, "moves_x", &Solid::moves_x, "Whether a free body moves along the channel.");
    add_freedom(s, "moves_y", &Solid::moves_y,
                "Whether a free body moves across the channel, in three dimensions.");
    add_freedom(s, "moves_z", &Solid::moves_z, "Whether a free body moves upward and downward.");
    add_freedom(s, "turns_x", &Solid::turns_x, "Whether a free body turns about x, in three dimensions.");
    add_freedom(s, "turns_y", &Solid::turns_y, "Whether a free body turns about y.");
    add_freedom(s, "turns_z", &Solid::turns_z, "Whether a free body turns about z, in three dimensions.");
    add_spring(
        s, "spring_x", &Solid::spring_x,
        "Stiffness of a spring that pulls a free body's centre of mass back to its x at t = 0, N/m; in two "
        "dimensions per width.");
    add_spring(s, "spring_y", &Solid::spring_y, "The same along y, in three dimensions.");
    add_spring(s, "spring_z", &Solid::spring_z, "The same along z.");
    s.keys.push_back(solid_key("restitution", &Solid::restitution,
                               "Speed after an impact over that before it, without water, of a free body "
                               "against walls and other solids; between two free bodies the mean of theirs.")
                         .greater_than(0)
                         .at_most(1)
                         .applies_with(motion, {"free"}, true));
    s.keys.push_back(solid_key("friction", &Solid::friction,
                               "Coulomb's coefficient of friction of a free body against walls and other "
                               "solids; between two free bodies the mean of theirs.")
                         .at_least(0)
                         .at_most(10)
                         .applies_with(motion, {"free"}, true));
}

}  // namespace riffle::inline case_file
