#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

// Parts of the chapter on the course of a flow that nothing drives steadily.

/// Kinetic, potential and elastic energy in time, and of vortices in a periodic box their exact decay.
void add_energies(const FlowRecord& record, Analysis& analysis);

/// Volume of the water in time, by the density of the particles and under the recorded surface.
void add_volumes(const FlowRecord& record, const SpaceTime& surface, Analysis& analysis);

/// The first mode of the surface of a standing wave, or of a tank full of water without bodies: its amplitude
/// in time, period and decay beside those of linear theory.
void add_surface_modes(const FlowRecord& record, const SpaceTime& surface, Analysis& analysis);

}  // namespace riffle::inline analysis
