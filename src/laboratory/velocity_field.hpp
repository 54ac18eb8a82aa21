#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/csv_table.hpp"

namespace riffle::inline laboratory {

/// Velocities on a grid of the x-z plane, as of particle image velocimetry: one field of means, or frames.
struct VelocityField {
    std::filesystem::path source;  ///< the file, or the folder of the frames
    std::string title;
    std::vector<double> x;     ///< columns, m along the channel
    std::vector<double> z;     ///< rows, m over the datum
    std::vector<double> time;  ///< of the frames, s; empty where it is not known
    std::size_t frames = 0;
    /// [(frame * z.size() + j) * x.size() + i] at (x[i], z[j]), m/s; not a number where no vector was found.
    std::vector<double> u, w;
    /// Standard uncertainties, m/s, of a single field; empty: not given.
    std::vector<double> u_uncertainty, w_uncertainty;
    std::vector<std::string> warnings;

    [[nodiscard]] std::size_t points() const { return x.size() * z.size(); }
};

/// Read a field or frames (docs/laboratory-data.md):
/// - a CSV table of x, z, u, w, in any order of the points, with uncertainties, and with a column t of
///   several frames below each other;
/// - the text export of OpenPIV (columns x y u v flags mask under a "#" line; y is the height, v the velocity
///   along it; flags 1 and masked vectors are left out);
/// - the text export of DaVis (a first line "#DaVis ..." with the units in quotes, then x y vx vy; vectors
///   that are exactly zero are places without one);
/// - a folder of such files, one frame each, in the order of their names.
/// Comments "# x_offset: 10 mm", "# z_offset: 4 mm" are added to the positions, "# flow: -x" turns x and u
/// round, "# units: mm, m/s" gives those of a file whose columns have none, "# time: 0.04 s" is that of a
/// frame. `sampling_frequency` (Hz) gives times to frames without. Throws FileError with file and line:
/// points that lie on no grid, frames on different grids, two values at one point, units that are not known.
[[nodiscard]] VelocityField read_velocity_field(const std::filesystem::path& path,
                                                std::optional<double> sampling_frequency = {});

/// Whether a table holds velocities in the x-z plane.
[[nodiscard]] bool is_velocity_field(const CsvTable& table);

/// Read the table of a text export, or a CSV table as read_csv_table() does: the heading that stands in a
/// comment made one, columns between blanks separated. Throws as read_csv_table().
[[nodiscard]] CsvTable read_field_table(const std::filesystem::path& path);

}  // namespace riffle::inline laboratory
