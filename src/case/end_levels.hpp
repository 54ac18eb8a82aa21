#pragma once

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Depth of critical flow with a discharge, m: (q^2/g)^(1/3); `gravity` normal to the bed, m/s2,
/// `unit_discharge` in m2/s.
[[nodiscard]] double critical_depth_of(double gravity, double unit_discharge);

/// The same of a discharge over the width of the channel of a case, over the lowest point where its channel
/// has a cross-section of its own: q^2 B = g A^3.
[[nodiscard]] double critical_depth_of(const Case& c, double unit_discharge);

/// Head over a sharp crest that lets a discharge pass, m: (3 q / (2 C_d sqrt(2 g)))^(2/3) (Poleni); nothing
/// without discharge.
[[nodiscard]] double weir_head(double gravity, double discharge_coefficient, double unit_discharge);

/// The highest level that the keys of open ends name, m over z = 0: the depths that are held, and what the
/// discharge needs to pass them, critical flow or the head over the crest of a weir. Files are not read. 0 of
/// other channels and of ducts.
[[nodiscard]] double highest_end_level(const Case& c);

/// The least depth of all the water, over what it stands on, that the keys of a case name: of the channel,
/// and of open ends those that are held; m.
struct LeastDepth {
    double depth = 0.0;
    const char* of = nullptr;  ///< "the inflow" or "the outflow"; null: the channel
};
[[nodiscard]] LeastDepth least_named_depth(const Case& c);

/// Whether files tell how discharge or depth at open ends change, or which depth goes with which discharge.
[[nodiscard]] bool has_end_tables(const Case& c);

/// Whether what enters an open channel follows a file in time, as a flood does.
[[nodiscard]] bool inflow_changes(const Case& c);

/// Whether the depth at the outflow of an open channel follows a file in time, as a tide does.
[[nodiscard]] bool tailwater_changes(const Case& c);

/// Whether discharge or depth at open ends change in time by a file.
[[nodiscard]] bool changes_at_ends(const Case& c);

/// Whether a run goes on until the flow between open ends is steady.
[[nodiscard]] inline bool converges_between_ends(const Case& c) {
    return c.channel.ends == Ends::open && c.run.until == RunUntil::converged;
}

/// The highest level that these files may ask for, m over z = 0: four times that of the case. The domain has
/// room for it, and for waves above.
[[nodiscard]] double level_with_room(const Case& c);

}  // namespace riffle::inline case_file
