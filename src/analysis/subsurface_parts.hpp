#pragma once

#include <string>
#include <vector>

#include "analysis/depth_correlation.hpp"
#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "analysis/probe_point_statistics.hpp"

namespace riffle::inline analysis {

// The parts of the chapter on the velocities below the surface.

/// A probe with the statistics of its points.
struct VelocityInstrument {
    const VelocityProbe* probe = nullptr;
    std::vector<ProbePointStatistics> points;
    double interval = 0;
};

/// "z = 12.5 mm".
[[nodiscard]] std::string place(const ProbePointStatistics& point);

/// Records at even times of one component of a probe at some of its points. Throws InputError where one has
/// gaps.
[[nodiscard]] std::vector<HeightRecord> height_records(const VelocityProbe& probe,
                                                       const std::vector<double>& values,
                                                       const std::vector<ProbePointStatistics>& points);

/// w' over the depth against w' at the highest point, with the influence depth of the surface. Nothing
/// without w or with fewer than three points.
void add_depth_correlation(const FlowRecord& record, const VelocityInstrument& instrument,
                           Analysis& analysis);

/// The thesis' correlation of w' between places along the stream at each height (4.8), from a plane of
/// velocities, with its influence depth.
void add_streamwise_correlation(const FlowRecord& record, Analysis& analysis);

/// w' at the highest point against the ejections at points below it, over the lag. Nothing without w or with
/// fewer than three points.
void add_ejections_and_upwellings(const FlowRecord& record, const VelocityInstrument& instrument,
                                  Analysis& analysis);

/// Parts of the Reynolds stress by quadrant over the depth, and against the hole size. Nothing without w.
void add_quadrants(const FlowRecord& record, const VelocityInstrument& instrument, Analysis& analysis);

}  // namespace riffle::inline analysis
