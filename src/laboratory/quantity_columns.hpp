#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/csv_table.hpp"

namespace riffle::inline laboratory {

/// What a record of velocities can hold beside positions. All are time means.
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

/// One measured quantity at the points of a record, in SI.
struct ProfileColumn {
    ProfileQuantity quantity = ProfileQuantity::velocity;
    std::vector<double> values;       ///< not a number where the file has no value
    std::vector<double> uncertainty;  ///< standard uncertainty; empty: not given
};

/// The positions and quantities of a table, in the order of its rows.
struct QuantityColumns {
    std::vector<double> x, y, z;  ///< m; empty: no such column
    std::vector<ProfileColumn> columns;
    std::vector<std::string> warnings;  ///< columns that are not used

    /// The column of a quantity; nullptr if the file has none.
    [[nodiscard]] const ProfileColumn* find(ProfileQuantity quantity) const;
};

/// Whether a table has a column of this position: "x", "y" (across the channel) or "z" (or "height").
[[nodiscard]] bool has_position(const CsvTable& table, char axis);

/// Take the positions and the quantities, known by their usual names (docs/laboratory-data.md), each with its
/// uncertainty where there is a column NAME_uncertainty. A column u'w' (without the sign) is turned to
/// -u'w'. In a table without header, or none of whose names is known, the first columns are z, u and the
/// uncertainty of u. Throws FileError with line and column: a column twice, an uncertainty that is not
/// greater than zero or stands without its quantity, a table of other columns without names. `axes`: the
/// positions that are taken, of "xyz"; columns of the others are not used.
[[nodiscard]] QuantityColumns quantity_columns(const CsvTable& table, std::string_view axes);

/// "u: 2 of 30 points have no value" of each column with gaps.
[[nodiscard]] std::vector<std::string> missing_values(const std::vector<ProfileColumn>& columns,
                                                      std::size_t points);

/// Bring values into an order: the new value i is the old value order[i].
template <class T>
void reorder(std::vector<T>& values, const std::vector<std::size_t>& order) {
    if (values.empty()) return;
    std::vector<T> sorted;
    sorted.reserve(values.size());
    for (const std::size_t i : order) sorted.push_back(values[i]);
    values = std::move(sorted);
}

}  // namespace riffle::inline laboratory
