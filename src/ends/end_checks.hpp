#pragma once

#include "case/case.hpp"
#include "ends/end_input.hpp"

namespace riffle::inline ends {

/// Throws FileError where fewer than two heights of [inflow] profile_file lie in the water at the inflow, as
/// where they are in another unit than the heading says. \param floor what the water stands on at the inflow,
/// m
void require_profile_in_water(const Case& c, double floor);

/// Throws InputError or FileError where a table, a weir or a rating curve holds the water at the outflow
/// below the critical depth of what enters at that time: water leaves at the critical depth where nothing
/// holds it back. \param floor what the water stands on at the outflow, m
void require_subcritical_outflow(const Case& c, const EndInput& input, double floor);

}  // namespace riffle::inline ends
