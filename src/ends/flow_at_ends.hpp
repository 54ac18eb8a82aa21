#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "hydraulics/varied_flow.hpp"

namespace riffle::inline ends {

/// The least and the largest value of a quantity during a run; equal where it does not change.
struct Extremes {
    double least = 0.0;
    double largest = 0.0;

    [[nodiscard]] bool changes() const { return largest > least; }
};

/// Where the depth at an end is taken from.
enum class DepthSource {
    given,      ///< what the case gives: [inflow] depth, or what the outflow holds
    backwater,  ///< the steady varied flow between the ends, as riffle backwater finds it
    uniform,    ///< uniform flow over the bed there with the discharge that changes: the flow itself will
                ///< decide
    steady,     ///< the steady varied flow between the ends with each discharge of a hydrograph
    start,      ///< the water of the start, at least the critical depth: the flow itself will decide
    full,       ///< the height of a duct
    unknown     ///< nothing tells it
};

/// The flow at an end as the case asks for it.
struct FlowAtEnd {
    DepthSource source = DepthSource::unknown;
    std::optional<Extremes> depth;  ///< over the datum, m; of a duct its height over what it stands on
    /// U, m/s: the depth mean over the datum where the case has a column twin, as that of riffle backwater;
    /// otherwise q over the whole depth (between side walls too).
    std::optional<Extremes> velocity;
    std::optional<Extremes> froude;  ///< as SteadyChannel::froude_number(); not of ducts
    double floor = 0.0;  ///< top of the solid that carries the water through this end, over the datum, m; 0
                         ///< without one
    std::optional<Extremes> critical_depth;  ///< of q, over the datum, or over the solid at this end, m
    bool critical_of_profile = false;        ///< with the twin's profile of the velocity, not (q2/g)^(1/3)
    /// Of q over the bed at this end, over the datum, m; none without slope or friction.
    std::optional<Extremes> normal_depth;
};

/// What a case with open ends asks for at them.
struct FlowAtEnds {
    FlowAtEnd inflow;
    FlowAtEnd outflow;  ///< in steady flow: with the discharge of the inflow
    bool gives_discharge = true;
    Extremes unit_discharge;                  ///< q, m2/s; where the case gives none that of the start
    std::optional<Extremes> held_depth;       ///< that the outflow holds, over the datum, m
    double holding_time = 0.0;                ///< in which the depth at the outflow goes to it, s
    bool one_bed = true;                      ///< both ends have the same bed, and stand on it
    std::optional<VariedFlow> varied;         ///< the steady varied flow between them, depths over the datum
    std::optional<Extremes> profile_heights;  ///< of the points of inflow.profile_file, over the datum, m
    std::optional<Extremes> profile_gap;      ///< the widest stretch between two of these points, m
    std::optional<double> reynolds;           ///< of a duct: U, its hydraulic diameter, largest q
};

/// Find it, for the time that the run lasts at most. Throws as read_end_levels().
[[nodiscard]] FlowAtEnds flow_at_ends(const Case& c);

/// A line about the ends: a label and a sentence without a full stop.
struct EndFact {
    std::string label;
    std::string text;
};

/// The same in words, for people: inflow, outflow, and the depths of the discharge.
[[nodiscard]] std::vector<EndFact> end_facts(const Case& c, const FlowAtEnds& states);

}  // namespace riffle::inline ends
