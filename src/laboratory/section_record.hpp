#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "laboratory/quantity_columns.hpp"

namespace riffle::inline laboratory {

/// Where the distances across the channel of a file are counted from.
enum class LateralOrigin { wall, centreline };

/// What was measured at points across a channel: a profile over the width at one height or of depth means, or
/// points all over a cross-section.
struct SectionRecord {
    std::filesystem::path source;
    std::string title;  ///< comment "# title: ..."; may be empty
    LateralOrigin origin = LateralOrigin::wall;
    std::vector<double> y;  ///< across the channel, m from `origin`
    std::vector<double> z;  ///< over the datum, m; not a number: means over the depth
    std::vector<ProfileColumn> columns;
    std::vector<int> lines;  ///< of each point in the file
    std::vector<std::string> warnings;

    /// The column of a quantity; nullptr if the file has none.
    [[nodiscard]] const ProfileColumn* find(ProfileQuantity quantity) const;

    /// "PATH:LINE" of a point, for messages.
    [[nodiscard]] std::string place(std::size_t point) const;
};

/// Read the points of a cross-section: a column y, the height as a column z, or of all points as a comment
/// "# z: 12 mm" or "# z: depth mean", and quantities as in profiles (read_profile_record). The comment
/// "# y_from: centreline" says that y is counted from there, else it is from the side wall. The points are
/// sorted by height, then y. Throws FileError with line and column: no height, two points at one place, a
/// place that is no number.
[[nodiscard]] SectionRecord read_section_record(const std::filesystem::path& path);

}  // namespace riffle::inline laboratory
