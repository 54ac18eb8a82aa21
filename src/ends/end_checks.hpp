#pragma once

#include <string>

#include "case/case.hpp"
#include "ends/end_input.hpp"

namespace riffle::inline ends {

/// Throws FileError where fewer than two heights of [inflow] profile_file lie in the water at the inflow, as
/// where they are in another unit than the heading says. \param floor what the water stands on at the inflow,
/// m
void require_profile_in_water(const Case& c, double floor);

/// Throws FileError where tables give the inflow a depth above the critical one of its discharge at that
/// time: of slow water one of the two comes from downstream, and a section that holds both throws every wave
/// back. \param floor what the water stands on at the inflow, m
void require_supercritical_inflow(const Case& c, const EndInput& input, double floor);

/// Throws InputError or FileError where a table, a weir or a rating curve holds the water at the outflow
/// below the critical depth of what enters at that time: water leaves at the critical depth where nothing
/// holds it back. \param floor what the water stands on at the outflow, m
void require_subcritical_outflow(const Case& c, const EndInput& input, double floor);

/// Throws FileError where a file, or the case itself, asks for a level that the domain has no room for.
/// \param asking the file, or the case; \param what says whose level, as in "its largest depth is"; \param
/// level m over z = 0
void require_room(const Case& c, const std::string& asking, const std::string& what, double level);

/// Throws FileError where the domain has no room for what a rating curve, a weir or the normal depth holds at
/// the outflow under the largest discharge that enters in the time of the run. \param floor what the water
/// stands on there, m
void require_room_for_rule(const Case& c, const EndInput& input, double floor);

}  // namespace riffle::inline ends
