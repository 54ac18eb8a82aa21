#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "analysis/mean_flow.hpp"
#include "case/case.hpp"

namespace riffle::inline analysis {

// What the chapters on three-dimensional runs share.

/// Whether a record is a run in three dimensions.
[[nodiscard]] bool is_three_dimensional(const FlowRecord& record);

/// Whether the profiles of a run are means over a width with side walls: neither the column twin, of a wide
/// channel, nor what was measured at the centreline is like them.
[[nodiscard]] bool between_side_walls(const FlowRecord& record);

/// Stretch across the channel, m.
struct Strip {
    double from = 0;
    double to = 0;
};

/// The strip that profiles at a place y are averaged over: a lattice period of the spheres, of smooth beds a
/// tenth of the width; cut at the side walls.
[[nodiscard]] Strip strip_around(const Case& c, double y);

/// The one around the centreline.
[[nodiscard]] Strip centreline_strip(const Case& c);

/// Period of the bed's elements across the channel, m; of smooth beds none.
[[nodiscard]] std::optional<double> lattice_period_across(const Case& c);

/// Total mean shear stress of a section's cells, Pa: viscosity and closure, and the resolved Reynolds stress
/// of the motion in time and along the bed. `lateral`: tau_xy, else tau_xz.
[[nodiscard]] std::vector<double> total_stress(const FieldSums& section, double density, bool lateral);
/// The resolved part alone.
[[nodiscard]] std::vector<double> resolved_stress(const FieldSums& section, double density, bool lateral);

/// "distance from the side wall y", of a channel without such "distance across the channel y"; over what it
/// is divided by, as "/H".
[[nodiscard]] Axis across_axis(const Case& c, const char* over = "");

/// A profile over the heights of the mean field where water was.
struct SectionProfile {
    std::vector<double> z, value, half_width;
};

/// Mean profile of what `estimator` makes of the sums over a strip, one value per height.
[[nodiscard]] SectionProfile strip_profile(const MeanFlow& field, const Strip& strip,
                                           const SectionEstimator& estimator);

/// Mean velocity over the strip around the centreline; empty without a mean field.
[[nodiscard]] SectionProfile centreline_velocity_profile(const FlowRecord& record);

/// Depth-mean velocity of the water along the centreline, where surfaces and planes are recorded, m/s: that
/// of the strip around it between side walls, else bulk_velocity(). 0 between end walls, where the water goes
/// to and fro and no stream carries anything along.
[[nodiscard]] double velocity_at_centreline(const FlowRecord& record);

/// What velocity_at_centreline() is called: "depth-mean velocity U", between side walls that around the
/// centreline.
[[nodiscard]] const char* depth_mean_name(const FlowRecord& record);

/// So of the water at the surface; without a mean field, between side walls, 0; and between end walls.
[[nodiscard]] double surface_velocity_at_centreline(const FlowRecord& record);

/// Velocity that the patterns of the surface travel with, m/s: that of the water at the surface, the depth
/// mean where it is not known.
[[nodiscard]] double velocity_of_patterns(const FlowRecord& record);

/// Mean over the water above the datum and below the surface of a profile on these heights, of cells with so
/// much water in each (in any unit); not-a-number where it has no value there.
[[nodiscard]] double mean_above_datum(const Case& c, const std::vector<double>& z,
                                      const std::vector<double>& values, const std::vector<double>& water);

/// A profile of the section twin at the place y, linear between its cells.
[[nodiscard]] std::vector<double> twin_profile(const SectionTwin& twin, const std::vector<double>& values,
                                               double y);
/// Its mean over a strip.
[[nodiscard]] std::vector<double> twin_profile(const SectionTwin& twin, const std::vector<double>& values,
                                               const Strip& strip);
/// Its value at a place and height.
[[nodiscard]] double twin_value(const SectionTwin& twin, const std::vector<double>& values, double y,
                                double z);

/// Figure in the plane across the flow, both axes over the total depth, with maps of the values of the cells.
[[nodiscard]] Figure section_figure(const char* chapter, std::string key, std::string title,
                                    std::string caption, std::string source);
[[nodiscard]] ColourMap section_map(const MeanFlow& field, const Case& c, const std::vector<double>& values,
                                    std::string label, std::string unit, bool diverging);

/// Vectors of the secondary flow over the section in units of the total depth, as line segments with
/// arrow heads between breaks; the longest is a twelfth of the depth.
[[nodiscard]] Curve section_vectors(const MeanFlow& field, const FieldSums& section, const Case& c,
                                    double velocity_scale, const std::string& scale_name);

}  // namespace riffle::inline analysis
