#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "laboratory/section_record.hpp"

namespace riffle::inline column {

/// What was measured at points of a cross-section: y[i] from the side wall at y = 0, z[i] above the bed level
/// (not-a-number: means over the depth above the datum). Quantities have a value for each point, not-a-number
/// where none was measured, or are empty.
struct SectionPoints {
    std::string name;
    std::vector<double> y, z;
    std::vector<double> velocity, uncertainty;  ///< u and its standard uncertainty, m/s
    std::vector<double> spanwise_velocity, vertical_velocity;
    std::vector<double> reynolds_stress;  ///< -u'w', m2/s2

    [[nodiscard]] bool empty() const { return y.empty(); }
};

/// Points of a cross-section in the channel of a case; of a channel that is simulated to its plane of
/// symmetry those beyond it at their mirror image. Throws FileError, naming the line, for a point beside the
/// channel or outside of the water.
[[nodiscard]] SectionPoints section_points_of(const SectionRecord& record, const Case& c);

}  // namespace riffle::inline column
