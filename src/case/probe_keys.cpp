#include "case/probe_keys.hpp"

#include <utility>

#include "case/units.hpp"

namespace riffle::inline case_file {

SectionKeys probe_keys() {
    using enum Dimension;
    SectionKeys s{
        "probe",
        "An instrument that records while the run goes on; any number of them, each under [[probe]].",
        {},
        [](const Case& c) { return c.probes.size(); }};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("probe", name, &Case::probes, member, meaning);
    };
    const std::string kind = "probe.kind";
    s.keys.push_back(
        key("name", &Probe::name, "Name of its group in the results, /probes/NAME: letters, digits, _ and -.")
            .is_required()
            .with_example("\"adv\""));
    s.keys.push_back(
        key("kind", &Probe::kind, "What it measures.").is_required().with_example("\"velocity\""));
    s.keys.push_back(key("sampling_frequency", &Probe::sampling_frequency,
                         "Samples per simulated time: one at the first step at or after each multiple of its "
                         "inverse.")
                         .measured_in(frequency)
                         .greater_than(0)
                         .is_required()
                         .with_example("\"100 Hz\""));
    s.keys.push_back(
        key("start", &Probe::start, "Simulated time after which it records.").measured_in(time).at_least(0));
    s.keys.push_back(
        key("x", &Probe::x, "Positions along the channel; velocity and pressure: one, or as many as z.")
            .measured_in(length)
            .with_default_note("required for these kinds")
            .with_example("[\"100 mm\"]")
            .applies_with(kind, {"velocity", "wave", "flow_rate", "pressure"}, true));
    s.keys.push_back(key("y", &Probe::y,
                         "Positions across a three-dimensional channel: one, or as many as x (velocity and "
                         "pressure: as the points).")
                         .measured_in(length)
                         .may_be_empty()
                         .with_default_note("the centreline")
                         .with_example("[\"100 mm\"]")
                         .applies_with(kind, {"velocity", "wave", "surface_line", "grid", "pressure"}, true));
    s.keys.push_back(key("z", &Probe::z, "Heights above the bed level; one, or as many as x.")
                         .measured_in(length)
                         .with_default_note("required for these kinds")
                         .with_example("[\"20 mm\", \"30 mm\"]")
                         .applies_with(kind, {"velocity", "pressure"}, true));
    s.keys.push_back(
        key("solid", &Probe::solid,
            "Name of the [[solid]] that the gauges sit on: the place of its surface next to each "
            "point. They move with it; x, y and z are those at the start.")
            .with_default_note("none: gauges that stand still, in the water or on walls")
            .with_example("\"pier\"")
            .applies_with(kind, {"pressure"}, true));
    s.keys.push_back(key("diameter", &Probe::diameter,
                         "Diameter of the gauge's round face on its wall or solid, over which it takes the "
                         "mean, in two dimensions along a line; 0: a point.")
                         .measured_in(length)
                         .at_least(0)
                         .with_example("\"10 mm\"")
                         .applies_with(kind, {"pressure"}, true));
    s.keys.push_back(key("sampling_length", &Probe::sampling_length,
                         "Height of the measuring volume, over which the velocity is averaged; 0: a point.")
                         .measured_in(length)
                         .at_least(0)
                         .applies_with(kind, {"velocity"}, true));
    s.keys.push_back(key("spacing", &Probe::spacing, "Distance of the points.")
                         .measured_in(length)
                         .greater_than(0)
                         .unset_by("auto", "surface line: the particle spacing; grid: twice that")
                         .applies_with(kind, {"surface_line", "grid"}, true));
    const auto edge = [&](const char* name, auto member, const char* meaning, const char* otherwise) {
        return key(name, member, meaning)
            .measured_in(length)
            .unset_by("auto", otherwise)
            .applies_with(kind, {"grid"}, true);
    };
    s.keys.push_back(edge("x_from", &Probe::x_from, "First column of points.", "the start of the channel"));
    s.keys.push_back(edge("x_to", &Probe::x_to, "Where the columns end.", "the end of the channel"));
    s.keys.push_back(edge("z_from", &Probe::z_from, "First row of points, above the bed level.",
                          "half a spacing of the grid above the bed level"));
    s.keys.push_back(
        edge("z_to", &Probe::z_to, "Where the rows end, above the bed level.", "the total depth"));
    s.keys.push_back(key("averaging_time", &Probe::averaging_time,
                         "Length of the windows of the averages; 0: none, u and w of each sample.")
                         .measured_in(time)
                         .at_least(0)
                         .applies_with(kind, {"grid"}, true));
    return s;
}

}  // namespace riffle::inline case_file
