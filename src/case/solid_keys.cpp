#include "case/solid_keys.hpp"

#include <utility>

#include "case/units.hpp"

namespace riffle {

SectionKeys solid_keys() {
    using enum Dimension;
    SectionKeys s{"solid",
                  "A body that the water flows around; any number of them, each under [[solid]].",
                  {},
                  [](const Case& c) { return c.solids.size(); }};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("solid", name, &Case::solids, member, meaning);
    };
    const std::string motion = "solid.motion";
    s.keys.push_back(
        key("name", &Solid::name, "Name of the solid, for messages.").is_required().with_example("\"weir\""));
    s.keys.push_back(
        key("x", &Solid::x, "Corners of its outline along the channel, one after the other in either sense.")
            .measured_in(length)
            .with_default_note("required in two dimensions")
            .with_example("[\"100 mm\", \"140 mm\", \"140 mm\", \"100 mm\"]")
            .applies_with("channel.dimensions", {"2"}, true));
    s.keys.push_back(key("z", &Solid::z, "Heights of the same corners above the bed level.")
                         .measured_in(length)
                         .with_default_note("required in two dimensions")
                         .with_example("[\"0 mm\", \"0 mm\", \"20 mm\", \"20 mm\"]")
                         .applies_with("channel.dimensions", {"2"}, true));
    s.keys.push_back(
        key("file", &Solid::file, "STL file, binary or text, of its closed surface in three dimensions.")
            .with_default_note("required in three dimensions")
            .with_example("\"stone.stl\"")
            .applies_with("channel.dimensions", {"3"}, true));
    s.keys.push_back(key("scale", &Solid::scale, "Length of the file's unit.")
                         .measured_in(length)
                         .greater_than(0)
                         .applies_with("channel.dimensions", {"3"}, true));
    s.keys.push_back(key("place", &Solid::place, "x, y and z of the file's origin in the channel.")
                         .measured_in(length)
                         .may_be_empty()
                         .with_default_note("the channel's origin")
                         .with_example("[\"100 mm\", \"50 mm\", \"0 mm\"]")
                         .applies_with("channel.dimensions", {"3"}, true));
    s.keys.push_back(key("surface", &Solid::surface, "What the water does at it."));
    s.keys.push_back(key("motion", &Solid::motion, "Whether and how it moves."));
    s.keys.push_back(key("start", &Solid::start, "Simulated time at which it starts to move.")
                         .measured_in(time)
                         .at_least(0)
                         .applies_with(motion, {"constant", "oscillating"}, true));
    s.keys.push_back(key("stop", &Solid::stop, "Simulated time at which it stops, for good.")
                         .measured_in(time)
                         .at_least(0)
                         .unset_by("never", "it moves to the end of the run")
                         .applies_with(motion, {"constant", "oscillating"}, true));
    s.keys.push_back(key("velocity_x", &Solid::velocity_x, "Its velocity along the channel.")
                         .measured_in(velocity)
                         .applies_with(motion, {"constant"}, true));
    s.keys.push_back(
        key("velocity_y", &Solid::velocity_y, "Its velocity across the channel, in three dimensions.")
            .measured_in(velocity)
            .applies_with(motion, {"constant"}, true));
    s.keys.push_back(key("velocity_z", &Solid::velocity_z, "Its velocity upward.")
                         .measured_in(velocity)
                         .applies_with(motion, {"constant"}, true));
    s.keys.push_back(key("amplitude_x", &Solid::amplitude_x, "Amplitude of its swing along the channel.")
                         .measured_in(length)
                         .applies_with(motion, {"oscillating"}, true));
    s.keys.push_back(key("amplitude_y", &Solid::amplitude_y,
                         "Amplitude of its swing across the channel, in three dimensions.")
                         .measured_in(length)
                         .applies_with(motion, {"oscillating"}, true));
    s.keys.push_back(key("amplitude_z", &Solid::amplitude_z, "Amplitude of its swing upward.")
                         .measured_in(length)
                         .applies_with(motion, {"oscillating"}, true));
    s.keys.push_back(key("frequency", &Solid::frequency, "Swings per time.")
                         .measured_in(frequency)
                         .at_least(0)
                         .applies_with(motion, {"oscillating"}, true));
    return s;
}

}  // namespace riffle
