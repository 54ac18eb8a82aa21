#pragma once

#include <vector>

#include "analysis/flow_record.hpp"

namespace riffle::inline analysis {

/// The points of a section that lie over each other, from the bed up.
struct MeasuredStation {
    double y = 0;  ///< m
    std::vector<double> z, velocity, uncertainty, reynolds_stress;
};

/// The points of a section that lie beside each other, from the wall on.
struct MeasuredRow {
    double z = 0;  ///< m above the bed level
    std::vector<double> y, velocity, uncertainty, reynolds_stress;
};

/// Those places across the channel with at least three heights, by rising y.
[[nodiscard]] std::vector<MeasuredStation> measured_stations(const SectionPoints& points);

/// Those heights with at least three places, by rising height.
[[nodiscard]] std::vector<MeasuredRow> measured_rows(const SectionPoints& points);

/// Means over the depth, from the wall on; z is not a number.
[[nodiscard]] MeasuredRow measured_depth_means(const SectionPoints& points);

/// What a record's cross-section is drawn with: its own points of a laboratory record, what a run is compared
/// with.
[[nodiscard]] const SectionPoints& points_beside(const FlowRecord& record);

}  // namespace riffle::inline analysis
