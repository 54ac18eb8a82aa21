#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "laboratory/quantity_columns.hpp"

namespace riffle::inline laboratory {

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

}  // namespace riffle::inline laboratory
