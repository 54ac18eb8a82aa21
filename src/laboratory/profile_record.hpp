#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/csv_table.hpp"

namespace riffle {

/// What a profile can hold beside the height. All are time means.
enum class ProfileQuantity {
    velocity,           ///< u, streamwise, m/s
    spanwise_velocity,  ///< v, m/s
    vertical_velocity,  ///< w, normal to the bed, m/s
    streamwise_rms,     ///< rms of u', m/s
    spanwise_rms,       ///< rms of v', m/s
    vertical_rms,       ///< rms of w', m/s
    reynolds_stress,    ///< -u'w' (over the density), m2/s2
    velocity_gradient,  ///< du/dz, 1/s
};

/// Name of a quantity as in a file: "u", "v", "w", "u_rms", "v_rms", "w_rms", "-u'w'", "du/dz".
[[nodiscard]] std::string_view quantity_name(ProfileQuantity quantity);

/// One measured quantity over the height, in SI.
struct ProfileColumn {
    ProfileQuantity quantity = ProfileQuantity::velocity;
    std::vector<double> values;       ///< not a number where the file has no value
    std::vector<double> uncertainty;  ///< standard uncertainty; empty: not given
};

/// A measured profile, as of an ADV or PIV, the points by rising height.
struct ProfileRecord {
    std::filesystem::path source;
    std::string title;      ///< comment "# title: ..."; may be empty
    std::vector<double> z;  ///< m, over the level that the file tells or the case means
    std::vector<ProfileColumn> columns;
    std::vector<int> lines;  ///< of each point in the file
    std::vector<CsvComment> comments;
    std::vector<std::string> warnings;  ///< missing values, columns that are not used

    /// The column of a quantity; nullptr if the file has none.
    [[nodiscard]] const ProfileColumn* find(ProfileQuantity quantity) const;

    /// "PATH:LINE" of a point, for messages.
    [[nodiscard]] std::string place(std::size_t point) const;
};

/// Read a profile: a column `z` and any of the quantities, known by their usual names
/// (docs/laboratory-data.md), each with its uncertainty where there is a column NAME_uncertainty. A column
/// u'w' (without the sign) is turned to -u'w'. A file without header, or with a header none of whose names is
/// known, holds z, u and if there is a third column the uncertainty of u, in this order. Columns with other
/// names are not used, and told in `warnings`. Throws FileError with line and column: no z or nothing else,
/// two points at one height, an uncertainty that is not greater than zero.
[[nodiscard]] ProfileRecord read_profile_record(const std::filesystem::path& path);

}  // namespace riffle
