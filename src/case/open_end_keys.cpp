#include "case/open_end_keys.hpp"

#include <utility>

#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

using enum Dimension;

Key with_open_ends(Key key) { return std::move(key).applies_with("channel.ends", {"open"}, true); }

}  // namespace

SectionKeys inflow_keys() {
    SectionKeys s{
        "inflow",
        "What enters a channel with open ends at x = 0: a discharge, or a depth; both where the flow is "
        "supercritical.",
        {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return with_open_ends(make_key("inflow", name, &Case::inflow, member, meaning));
    };
    const char* const by_others = "another key of [inflow] says what enters";
    s.keys.push_back(key("discharge", &Inflow::discharge, "Discharge Q of the whole width, channel.width.")
                         .measured_in(discharge)
                         .at_least(0)
                         .unset_by("none", by_others));
    s.keys.push_back(key("unit_discharge", &Inflow::unit_discharge, "Discharge q of a unit of the width.")
                         .measured_in(kinematic_viscosity)
                         .at_least(0)
                         .unset_by("none", by_others)
                         .with_example("\"0.02 m2/s\""));
    s.keys.push_back(
        key("depth", &Inflow::depth,
            "Depth that is held at the inflow, over the zero datum like channel.depth.")
            .measured_in(length)
            .greater_than(0)
            .unset_by("none", "it follows from the discharge and from what comes up the channel"));
    s.keys.push_back(
        key("discharge_file", &Inflow::discharge_file,
            "CSV file of a hydrograph: the columns time, and discharge or unit_discharge; straight "
            "lines between its rows, the last value behind them.")
            .with_example("\"flood.csv\""));
    s.keys.push_back(key("depth_file", &Inflow::depth_file, "CSV file with the columns time, depth.")
                         .with_example("\"stage.csv\""));
    s.keys.push_back(key("profile", &Inflow::profile, "Profile of the velocity that enters."));
    const std::string profile = "inflow.profile";
    s.keys.push_back(make_key("inflow", "exponent", &Case::inflow, &Inflow::exponent, "m of the power law.")
                         .at_least(1)
                         .at_most(100)
                         .because("measured: 3 to 10")
                         .applies_with(profile, {"power-law"}, true));
    s.keys.push_back(make_key("inflow", "equivalent_roughness", &Case::inflow, &Inflow::equivalent_roughness,
                              "k_s of the log law.")
                         .measured_in(length)
                         .at_least(0)
                         .applies_with(profile, {"log-law"}, true));
    s.keys.push_back(make_key("inflow", "profile_file", &Case::inflow, &Inflow::profile_file,
                              "CSV file of the profile, the columns z, u; z above the zero datum.")
                         .applies_with(profile, {"file"}, true));
    s.keys.push_back(make_key("inflow", "results", &Case::inflow, &Inflow::results,
                              "Results file of a run with periodic ends over the same depth, whose snapshots "
                              "enter: in a loop, each carried along by the mean flow from one to the next, "
                              "scaled to the discharge.")
                         .with_example("\"reach/results.h5\"")
                         .applies_with(profile, {"results"}, true));
    s.keys.push_back(make_key("inflow", "results_from", &Case::inflow, &Inflow::results_from,
                              "Time of that run from which on its snapshots are taken.")
                         .measured_in(time)
                         .at_least(0)
                         .unset_by("auto", "`run.average_from` of that run")
                         .applies_with(profile, {"results"}, true));
    s.keys.push_back(
        key("relaxation_time", &Inflow::relaxation_time,
            "Time in which the discharge comes back after a wave has gone out through the inflow; its mean is "
            "the one given. 0: it holds at each moment, and waves are thrown back.")
            .measured_in(time)
            .at_least(0)
            .unset_by(
                "auto",
                "5 sqrt(H / g), and no longer than the default one of an outflow with a `depth_file`; in a duct 0.1 L / U_max"));
    return s;
}

SectionKeys outflow_keys() {
    SectionKeys s{
        "outflow", "What rules the water where it leaves a channel with open ends, at x = length.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("outflow", name, &Case::outflow, member, meaning);
    };
    const std::string kind = "outflow.kind";
    s.keys.push_back(with_open_ends(key("kind", &Outflow::kind, "What rules the depth at the outflow.")));
    s.keys.push_back(key("depth", &Outflow::depth, "Depth over the zero datum, like channel.depth.")
                         .measured_in(length)
                         .greater_than(0)
                         .unset_by("none", "`depth_file` gives it")
                         .applies_with(kind, {"depth"}, true));
    s.keys.push_back(key("depth_file", &Outflow::depth_file, "CSV file with the columns time, depth.")
                         .with_example("\"tide.csv\"")
                         .applies_with(kind, {"depth"}, true));
    s.keys.push_back(
        key("weir_height", &Outflow::weir_height, "Height of the weir's crest over the zero datum.")
            .measured_in(length)
            .at_least(0)
            .applies_with(kind, {"weir"}, true));
    s.keys.push_back(key("weir_coefficient", &Outflow::weir_coefficient,
                         "C_d of q = (2/3) C_d sqrt(2 g) head^(3/2); the head is that over the crest.")
                         .at_least(0.2)
                         .at_most(2)
                         .because("measured: 0.55 to 1.2")
                         .applies_with(kind, {"weir"}, true));
    s.keys.push_back(
        key("rating_file", &Outflow::rating_file,
            "CSV file of the rating curve, the columns depth, and discharge or unit_discharge, both rising.")
            .with_example("\"rating.csv\"")
            .applies_with(kind, {"rating-curve"}, true));
    s.keys.push_back(
        key("relaxation_time", &Outflow::relaxation_time,
            "Time in which the depth, in a duct the pressure, goes to what rules it: the longer, the less of a "
            "wave is thrown back.")
            .measured_in(time)
            .greater_than(0)
            .unset_by(
                "auto",
                "80 sqrt(H / g), at least the time that a wave takes along the channel; with `depth_file` at most 0.5 % "
                "of the time in which that depth would go through its range as fast as it ever changes, but at "
                "least sqrt(H / g); in a duct 0.1 L / U_max")
            .applies_with(
                kind, {"depth", "normal-depth", "critical-depth", "weir", "rating-curve", "pressure"}, true));
    return s;
}

}  // namespace riffle::inline case_file
