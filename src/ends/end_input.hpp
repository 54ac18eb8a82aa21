#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "case/case.hpp"
#include "ends/entering_flow.hpp"
#include "ends/time_table.hpp"
#include "hydraulics/varied_flow.hpp"

namespace riffle::inline ends {

/// What a case with open ends says of them, files read. Depths are those of the whole water over what it
/// stands on there (end_floors()), m.
struct EndInput {
    std::optional<TimeTable> unit_discharge;  ///< q at the inflow, m2/s
    std::optional<TimeTable> inflow_depth;
    std::shared_ptr<const EnteringFlow> entering;  ///< null of read_end_levels()
    /// Depth that rules the outflow, from the discharge that leaves (m2/s) and the time (s); none where
    /// nothing does.
    std::function<double(double unit_discharge, double time)> outflow_depth;
    std::optional<TimeTable> outflow_table;  ///< where that is a depth given in time
    double relaxation_time = 0.0;            ///< of the depth or the pressure at the outflow, s
    double inflow_relaxation_time = 0.0;     ///< of the discharge at the inflow, s
    bool duct = false;                       ///< water between the bed and a wall at the top
    double jet_velocity = 0.0;               ///< of a duct: largest of the jets behind what narrows it, m/s
    double outflow_pressure = 0.0;           ///< of a duct, over the density, m2/s2
};

/// Read it. Throws FileError or InputError that name file, line or key where something does not hold.
[[nodiscard]] EndInput read_end_input(const Case& c);

/// The discharges and depths alone, for which nothing of the velocity that enters needs to be there.
[[nodiscard]] EndInput read_end_levels(const Case& c);

/// Discharge of the start, m2/s: that of the inflow, or where the case gives none that of the uniform flow of
/// its bed; 0 where that is not known either.
[[nodiscard]] double start_unit_discharge(const Case& c, const EndInput& input);

/// The beginning and the end of a run, and the times between them of all rows of the tables that its ends
/// have, in no order: between two of them each table only rises or only falls.
[[nodiscard]] std::vector<double> times_of_tables(const Case& c, const EndInput& input);

/// What rules the steady varied flow between the ends as they are at a time, depths over the datum, of the
/// channel with the discharge of that time.
[[nodiscard]] ChannelControls controls_at_ends(const Case& c, const EndInput& input,
                                               const SteadyChannel& channel, double time = 0.0);

/// Total depth of the steady varied flow between the ends as they are at t = 0 (riffle backwater), m. Throws
/// InputError where there is none.
[[nodiscard]] std::function<double(double x)> varied_depths(const Case& c, const EndInput& input);

/// Total depth of the start along a channel with open ends.
[[nodiscard]] std::function<double(double x)> start_depths(const Case& c, const EndInput& input);

}  // namespace riffle::inline ends
